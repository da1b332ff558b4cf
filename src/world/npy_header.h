/// @file
/// The header of NumPy's .npy: where the numbers begin, how they are stored, and how many there are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "cellsweep/status.h"
#include "world/bytes.h"

namespace cellsweep {

/// What a header claims; nothing of it has been compared with the size of the file yet.
struct NpyHeader {
  ByteOrder order = ByteOrder::little;
  std::size_t number_bytes = 4;  ///< 4 for float32, 8 for float64
  std::uint64_t frames = 0;      ///< at least 1
  std::uint64_t bodies = 0;
  std::size_t data_offset = 0;  ///< at most the size of the file
};

/// Reads format versions 1.0, 2.0 and 3.0. The header's dictionary may come in any order and spacing that
/// Python reads; it must have exactly the three keys of the format. Errors: bad_input naming the byte offset,
/// also for what NumPy would read and this project does not: other types, Fortran order, other shapes.
Result<NpyHeader> parse_npy_header(std::span<const std::byte> file);

/// The bytes before the data of a version 1.0 file of little-endian float32, padded to 64 as NumPy does.
std::string npy_header_bytes(std::uint64_t frames, std::uint64_t bodies);

}  // namespace cellsweep
