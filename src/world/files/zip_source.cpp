#include "world/files/zip_source.h"

#include <cerrno>
#include <cstdint>
#include <new>
#include <utility>

namespace cellsweep {
namespace {

/// Where libzip is in a file that it reads, or writes.
struct ZipPlace {
  std::shared_ptr<const ByteSource> bytes;
  std::shared_ptr<ScratchFile> target;  // the same, or none: read only
  std::uint64_t read = 0;
  std::uint64_t write = 0;
  zip_error_t error{};
};

zip_int64_t fail(ZipPlace& place, int code, int system_error) {
  zip_error_set(&place.error, code, system_error);
  errno = system_error;
  return -1;
}

zip_int64_t read_some(ZipPlace& place, void* data, zip_uint64_t length) {
  const std::int64_t count =
      place.bytes->read_at(place.read, {static_cast<std::byte*>(data), static_cast<std::size_t>(length)});
  if (count < 0) return fail(place, ZIP_ER_READ, static_cast<int>(-count));
  place.read += static_cast<std::uint64_t>(count);
  return count;
}

zip_int64_t write_all(ZipPlace& place, const void* data, zip_uint64_t length) {
  if (!place.target->write_at(place.write,
                              {static_cast<const std::byte*>(data), static_cast<std::size_t>(length)}))
    return fail(place, ZIP_ER_WRITE, EIO);
  place.write += length;
  return static_cast<zip_int64_t>(length);
}

zip_int64_t seek(ZipPlace& place, std::uint64_t& at, void* data, zip_uint64_t length) {
  const zip_int64_t to = zip_source_seek_compute_offset(at, place.bytes->size(), data, length, &place.error);
  if (to < 0) return -1;
  at = static_cast<std::uint64_t>(to);
  return 0;
}

zip_int64_t tell_size(const ZipPlace& place, void* data, zip_uint64_t length) {
  if (length < sizeof(zip_stat_t)) return -1;
  auto* const stat = static_cast<zip_stat_t*>(data);
  zip_stat_init(stat);
  stat->size = place.bytes->size();
  stat->valid |= ZIP_STAT_SIZE;
  return sizeof(zip_stat_t);
}

zip_int64_t commands(const ZipPlace& place) {
  const zip_int64_t reading = zip_source_make_command_bitmap(
      ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE,
      ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL, ZIP_SOURCE_SUPPORTS, -1);
  if (!place.target) return reading;
  return reading | zip_source_make_command_bitmap(
                       ZIP_SOURCE_BEGIN_WRITE, ZIP_SOURCE_COMMIT_WRITE, ZIP_SOURCE_ROLLBACK_WRITE,
                       ZIP_SOURCE_WRITE, ZIP_SOURCE_SEEK_WRITE, ZIP_SOURCE_TELL_WRITE, ZIP_SOURCE_REMOVE, -1);
}

zip_int64_t answer_writer(ZipPlace& place, void* data, zip_uint64_t length, zip_source_cmd_t command) {
  switch (command) {
    case ZIP_SOURCE_BEGIN_WRITE:
      place.write = 0;
      return 0;
    case ZIP_SOURCE_WRITE:
      return write_all(place, data, length);
    case ZIP_SOURCE_SEEK_WRITE:
      return seek(place, place.write, data, length);
    case ZIP_SOURCE_TELL_WRITE:
      return static_cast<zip_int64_t>(place.write);
    case ZIP_SOURCE_COMMIT_WRITE:
    case ZIP_SOURCE_ROLLBACK_WRITE:
    case ZIP_SOURCE_REMOVE:
      return 0;
    default:
      return fail(place, ZIP_ER_OPNOTSUPP, 0);
  }
}

// What libzip asks of a source. Nothing may be thrown through its frames.
zip_int64_t answer(void* state, void* data, zip_uint64_t length, zip_source_cmd_t command) noexcept {
  ZipPlace& place = *static_cast<ZipPlace*>(state);
  switch (command) {
    case ZIP_SOURCE_OPEN:
      place.read = 0;
      return 0;
    case ZIP_SOURCE_READ:
      return read_some(place, data, length);
    case ZIP_SOURCE_CLOSE:
      return 0;
    case ZIP_SOURCE_STAT:
      return tell_size(place, data, length);
    case ZIP_SOURCE_ERROR:
      return zip_error_to_data(&place.error, data, length);
    case ZIP_SOURCE_FREE:
      delete &place;
      return 0;
    case ZIP_SOURCE_SEEK:
      return seek(place, place.read, data, length);
    case ZIP_SOURCE_TELL:
      return static_cast<zip_int64_t>(place.read);
    case ZIP_SOURCE_SUPPORTS:
      return commands(place);
    default:
      return answer_writer(place, data, length, command);
  }
}

ZipSource source_of(std::unique_ptr<ZipPlace> place) {
  zip_error_init(&place->error);
  ZipSource source(zip_source_function_create(answer, place.get(), nullptr));
  if (!source) throw std::bad_alloc();
  static_cast<void>(place.release());  // the source's
  return source;
}

}  // namespace

ZipSource make_zip_source(std::shared_ptr<const ByteSource> bytes) {
  auto place = std::make_unique<ZipPlace>();
  place->bytes = std::move(bytes);
  return source_of(std::move(place));
}

ZipSource make_zip_target(std::shared_ptr<ScratchFile> file) {
  auto place = std::make_unique<ZipPlace>();
  place->bytes = file;
  place->target = std::move(file);
  return source_of(std::move(place));
}

}  // namespace cellsweep
