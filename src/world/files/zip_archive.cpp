#include "world/files/zip_archive.h"

#include <zip.h>

#include <cerrno>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>

#include "world/files/file_fault.h"

namespace cellsweep {
namespace {

/// What libzip says of a failure.
class ZipError {
 public:
  ZipError() { zip_error_init(&error_); }
  ZipError(const ZipError&) = delete;
  ZipError& operator=(const ZipError&) = delete;
  ~ZipError() { zip_error_fini(&error_); }

  zip_error_t* get() { return &error_; }

 private:
  zip_error_t error_{};
};

struct ArchiveCloser {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Archive = std::unique_ptr<zip_t, ArchiveCloser>;

struct SourceCloser {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, SourceCloser>;

struct MemberCloser {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using MemberFile = std::unique_ptr<zip_file_t, MemberCloser>;

// What libzip says of a failure; std::bad_alloc for want of memory, which it does not always tell: errno
// does, if it was 0 before.
std::string reason_of(zip_error_t* error) {
  if (zip_error_code_zip(error) == ZIP_ER_MEMORY || errno == ENOMEM) throw std::bad_alloc();
  return zip_error_strerror(error);
}

Status bad_archive(const std::string& why) {
  return bad_recording("expected a zip archive that is whole, found one of which libzip says: " + why);
}

Status cannot_write(const std::string& why) {
  return bad_recording("the archive cannot be written: " + why);
}

/// No data: an archive to be made.
Source make_source(std::span<const std::byte> data) {
  ZipError error;
  Source source(zip_source_buffer_create(data.empty() ? nullptr : data.data(), data.size(), 0, error.get()));
  if (!source) throw std::bad_alloc();
  return source;
}

/// Deflate makes a thousand bytes into one at best.
bool is_possible(std::uint64_t claimed, std::uint64_t archive_bytes) {
  constexpr std::uint64_t kMostOfOne = 1100;
  return claimed / kMostOfOne <= archive_bytes;
}

Result<ZipMember> read_member(zip_t* archive, std::uint64_t index, const zip_stat_t& stat) {
  ZipMember member{stat.name, {}};
  const MemberFile file(zip_fopen_index(archive, index, 0));
  if (!file) return bad_archive(reason_of(zip_get_error(archive)));
  member.bytes.resize(stat.size);
  std::uint64_t done = 0;
  while (done < stat.size) {
    const zip_int64_t count = zip_fread(file.get(), member.bytes.data() + done, stat.size - done);
    if (count <= 0) break;
    done += static_cast<std::uint64_t>(count);
  }
  // Behind the last byte the checksum is compared.
  char more = 0;
  if (done != stat.size || zip_fread(file.get(), &more, 1) != 0)
    return bad_archive("member " + cellsweep::quoted(member.name) + ": " +
                       reason_of(zip_file_get_error(file.get())));
  return member;
}

Status add_member(zip_t* archive, const ZipMember& member) {
  constexpr zip_uint16_t kFirstOfJanuary1980 = 1 << 5 | 1;
  zip_source_t* source = zip_source_buffer(archive, member.bytes.data(), member.bytes.size(), 0);
  if (source == nullptr) return cannot_write(reason_of(zip_get_error(archive)));
  const zip_int64_t index = zip_file_add(archive, member.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return cannot_write(reason_of(zip_get_error(archive)));
  }
  if (zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), 0, kFirstOfJanuary1980, 0) != 0)
    return cannot_write(reason_of(zip_get_error(archive)));
  return {};
}

Result<std::vector<std::byte>> content_of(zip_source_t* source) {
  const auto failure = [&] { return cannot_write(reason_of(zip_source_error(source))); };
  if (zip_source_open(source) != 0) return failure();
  std::vector<std::byte> bytes;
  if (zip_source_seek(source, 0, SEEK_END) == 0)
    bytes.resize(static_cast<std::size_t>(zip_source_tell(source)));
  const bool read =
      zip_source_seek(source, 0, SEEK_SET) == 0 &&
      zip_source_read(source, bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size());
  zip_source_close(source);
  if (!read) return failure();
  return bytes;
}

Result<std::vector<ZipMember>> read_members(Source source, std::uint64_t archive_bytes) {
  ZipError error;
  const Archive archive(zip_open_from_source(source.get(), ZIP_RDONLY | ZIP_CHECKCONS, error.get()));
  if (!archive) return bad_archive(reason_of(error.get()));
  static_cast<void>(source.release());  // the archive's
  std::vector<ZipMember> members;
  std::uint64_t claimed = 0;
  const auto count = static_cast<std::uint64_t>(zip_get_num_entries(archive.get(), 0));
  for (std::uint64_t index = 0; index < count; ++index) {
    zip_stat_t stat;
    constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE;
    if (zip_stat_index(archive.get(), index, 0, &stat) != 0 || (stat.valid & kNeeded) != kNeeded)
      return bad_archive(reason_of(zip_get_error(archive.get())));
    if (!is_possible(stat.size, archive_bytes) || !is_possible(claimed += stat.size, archive_bytes)) {
      return bad_recording("expected members of no more than 1100 times the archive's " +
                           std::to_string(archive_bytes) + " bytes, found " + cellsweep::quoted(stat.name) +
                           " of " + std::to_string(stat.size));
    }
    Result<ZipMember> member = read_member(archive.get(), index, stat);
    if (!member) return member.status();
    members.push_back(std::move(*member));
  }
  return members;
}

}  // namespace

bool zip_is_there() {
  return true;
}

Result<std::vector<ZipMember>> read_zip(std::span<const std::byte> bytes) {
  if (bytes.empty()) return bad_archive("No bytes");
  errno = 0;
  return read_members(make_source(bytes), bytes.size());
}

Result<std::vector<ZipMember>> read_zip_file(const std::string& path, std::uint64_t bytes) {
  errno = 0;
  ZipError error;
  Source source(zip_source_file_create(path.c_str(), 0, -1, error.get()));
  if (!source) return bad_archive(reason_of(error.get()));
  return read_members(std::move(source), bytes);
}

Result<std::vector<std::byte>> zip_bytes(std::span<const ZipMember> members) {
  errno = 0;
  ZipError error;
  const Source source = make_source({});
  Archive archive(zip_open_from_source(source.get(), ZIP_CREATE | ZIP_TRUNCATE, error.get()));
  if (!archive) return cannot_write(reason_of(error.get()));
  zip_source_keep(source.get());  // the archive has one, and this function one
  for (const ZipMember& member : members) {
    if (Status status = add_member(archive.get(), member); !status.ok()) return status;
  }
  if (zip_close(archive.get()) != 0) return cannot_write(reason_of(zip_get_error(archive.get())));
  static_cast<void>(archive.release());
  return content_of(source.get());
}

}  // namespace cellsweep
