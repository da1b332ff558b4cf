/// @file
/// The first bytes of a checkpoint: what it is, how long it is, and a checksum of all that follows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "cellsweep/status.h"

namespace cellsweep::ranks {

/// HDF5 leaves so many bytes at the beginning of a file to its users.
inline constexpr std::size_t kSealBytes = 512;

struct Seal {
  std::uint64_t bytes = 0;  ///< of the whole file
  std::uint64_t checksum = 0;

  friend bool operator==(const Seal&, const Seal&) = default;
};

/// Of this machine's file. Errors: bad_input where it cannot be read, is no checkpoint, or has not the length
/// that it says.
Result<Seal> read_seal(const std::string& path);

/// Writes it over the file's first bytes and puts the file on the disk. Errors: write_failed.
Status write_seal(const std::string& path, const Seal& seal);

/// The length of a file. Errors: bad_input.
Result<std::uint64_t> file_bytes(const std::string& path);

/// The share of part `part` of `parts` in the checksum of a file of `bytes`: those of all parts, by XOR, are
/// that of the file. Changing one byte changes it for certain, changing more very probably. Errors:
/// bad_input.
Result<std::uint64_t> checksum_of_part(const std::string& path, std::uint64_t bytes, int part, int parts);

}  // namespace cellsweep::ranks
