#include "world/files/zip_archive.h"

#include <zip.h>

#include <cerrno>
#include <memory>
#include <new>
#include <utility>

#include "world/files/file_fault.h"
#include "world/files/zip_source.h"

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

/// Deflate makes a thousand bytes into one at best.
bool is_possible(std::uint64_t claimed, std::uint64_t archive_bytes) {
  constexpr std::uint64_t kMostOfOne = 1100;
  return claimed / kMostOfOne <= archive_bytes;
}

Status list_members(zip_t* archive, std::uint64_t archive_bytes, std::vector<ZipArchive::Member>& members) {
  std::uint64_t claimed = 0;
  const auto count = static_cast<std::uint64_t>(zip_get_num_entries(archive, 0));
  for (std::uint64_t index = 0; index < count; ++index) {
    zip_stat_t stat;
    constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE;
    if (zip_stat_index(archive, index, 0, &stat) != 0 || (stat.valid & kNeeded) != kNeeded)
      return bad_archive(reason_of(zip_get_error(archive)));
    if (!is_possible(stat.size, archive_bytes) || !is_possible(claimed += stat.size, archive_bytes)) {
      return bad_recording("expected members of no more than 1100 times the archive's " +
                           std::to_string(archive_bytes) + " bytes, found " + cellsweep::quoted(stat.name) +
                           " of " + std::to_string(stat.size));
    }
    members.push_back({stat.name, stat.size});
  }
  return {};
}

Status add_member(zip_t* archive, const ZipMember& member) {
  constexpr zip_uint16_t kFirstOfJanuary1980 = 1 << 5 | 1;
  ZipSource source = make_zip_source(member.bytes);
  const zip_int64_t index = zip_file_add(archive, member.name.c_str(), source.get(), ZIP_FL_ENC_UTF_8);
  if (index < 0) return cannot_write(reason_of(zip_get_error(archive)));
  static_cast<void>(source.release());  // the archive's
  if (zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), 0, kFirstOfJanuary1980, 0) != 0)
    return cannot_write(reason_of(zip_get_error(archive)));
  return {};
}

}  // namespace

bool zip_is_there() {
  return true;
}

Result<ZipArchive> ZipArchive::open(std::shared_ptr<const ByteSource> bytes) {
  const std::uint64_t size = bytes->size();
  if (size == 0) return bad_archive("No bytes");
  errno = 0;
  ZipError error;
  ZipSource source = make_zip_source(std::move(bytes));
  Archive archive(zip_open_from_source(source.get(), ZIP_RDONLY | ZIP_CHECKCONS, error.get()));
  if (!archive) return bad_archive(reason_of(error.get()));
  static_cast<void>(source.release());  // the archive's
  ZipArchive opened;
  opened.archive_ = std::move(archive);
  if (Status status = list_members(opened.archive_.get(), size, opened.members_); !status.ok()) return status;
  return opened;
}

Result<ZipStream> ZipArchive::stream(std::size_t member) const {
  errno = 0;
  std::shared_ptr<zip_file> file(zip_fopen_index(archive_.get(), member, 0), [](zip_file_t* open) {
    if (open != nullptr) zip_fclose(open);
  });
  if (!file) return bad_archive(reason_of(zip_get_error(archive_.get())));
  return ZipStream(archive_, std::move(file), members_[member].name);
}

Status ZipStream::broken() const {
  return bad_archive("member " + cellsweep::quoted(name_) + ": " +
                     reason_of(zip_file_get_error(file_.get())));
}

Status ZipStream::read(std::span<std::byte> bytes) {
  errno = 0;
  while (!bytes.empty()) {
    const zip_int64_t count = zip_fread(file_.get(), bytes.data(), bytes.size());
    if (count <= 0) return broken();
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return {};
}

// Behind the last byte the checksum is compared.
Status ZipStream::finish() {
  errno = 0;
  char more = 0;
  return zip_fread(file_.get(), &more, 1) == 0 ? Status() : broken();
}

Status write_zip(std::span<const ZipMember> members, const std::shared_ptr<ScratchFile>& file) {
  errno = 0;
  ZipError error;
  ZipSource source = make_zip_target(file);
  Archive archive(zip_open_from_source(source.get(), ZIP_CREATE | ZIP_TRUNCATE, error.get()));
  if (!archive) return cannot_write(reason_of(error.get()));
  static_cast<void>(source.release());  // the archive's
  for (const ZipMember& member : members) {
    if (Status status = add_member(archive.get(), member); !status.ok()) return status;
  }
  if (zip_close(archive.get()) != 0) {
    if (Status status = file->status(); !status.ok()) return status;
    Status status = cannot_write(reason_of(zip_get_error(archive.get())));
    if (zip_error_code_zip(zip_get_error(archive.get())) == ZIP_ER_READ)
      status.code = StatusCode::write_failed;
    return status;
  }
  static_cast<void>(archive.release());
  return {};
}

}  // namespace cellsweep
