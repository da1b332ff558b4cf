/// @file
/// Zip archives that are read and written a part at a time, by libzip.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/status.h"
#include "world/files/byte_source.h"
#include "world/files/scratch_file.h"

struct zip;       // libzip's archive
struct zip_file;  // and an open member of it

namespace cellsweep {

/// False in a build without libzip; all calls refuse then.
bool zip_is_there();

/// One member from its first byte to its last.
class ZipStream {
 public:
  ZipStream(std::shared_ptr<zip> archive, std::shared_ptr<zip_file> file, std::string name)
      : archive_(std::move(archive)), file_(std::move(file)), name_(std::move(name)) {}

  /// The next bytes; there are as many. Errors of these: bad_input for a broken member.
  Status read(std::span<std::byte> bytes);
  /// After the last byte: there is no more, and the checksum is right.
  Status finish();

 private:
  Status broken() const;

  std::shared_ptr<zip> archive_;  // outlives the member
  std::shared_ptr<zip_file> file_;
  std::string name_;
};

/// An archive to read from. One thread at a time, that of its streams.
class ZipArchive {
 public:
  struct Member {
    std::string name;
    std::uint64_t bytes = 0;  ///< what the archive says
  };

  /// Reads what it says of its members. Errors: bad_input for what is no archive, or a broken one, or one
  /// that says it holds more than a thousand times its own size, which no compression does.
  static Result<ZipArchive> open(std::shared_ptr<const ByteSource> bytes);

  const std::vector<Member>& members() const { return members_; }
  /// Errors: bad_input. Several may be open at a time.
  Result<ZipStream> stream(std::size_t member) const;

 private:
  std::shared_ptr<zip> archive_;
  std::vector<Member> members_;
};

/// What goes into an archive.
struct ZipMember {
  std::string name;
  std::shared_ptr<const ByteSource> bytes;
};

/// Fills an empty file; the same members give the same bytes. Errors: bad_input, and those of the file.
Status write_zip(std::span<const ZipMember> members, const std::shared_ptr<ScratchFile>& archive);

}  // namespace cellsweep
