/// @file
/// Zip archives in memory, by libzip.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/status.h"

namespace cellsweep {

struct ZipMember {
  std::string name;
  std::vector<std::byte> bytes;
};

/// False in a build without libzip; both calls refuse then.
bool zip_is_there();

/// All members, their checksums compared. Errors: bad_input for what is no archive, or a broken one, or one
/// that says it holds more than a thousand times its own size, which no compression does.
Result<std::vector<ZipMember>> read_zip(std::span<const std::byte> archive);

/// The same of a file of so many bytes, of which no more is read than is needed.
Result<std::vector<ZipMember>> read_zip_file(const std::string& path, std::uint64_t bytes);

/// The same members give the same bytes.
Result<std::vector<std::byte>> zip_bytes(std::span<const ZipMember> members);

}  // namespace cellsweep
