/// @file
/// The header of NumPy's .npy: where the numbers begin, how they are stored, and how many there are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/status.h"
#include "world/files/bytes.h"

namespace cellsweep {

/// What a header claims; nothing of it has been compared with the size of the file yet.
struct NpyHeader {
  std::string type;               ///< as NumPy writes it: "<f4"
  std::uint64_t type_offset = 0;  ///< where in the file that stands
  std::vector<std::uint64_t> shape;
  std::string shape_text;
  std::uint64_t shape_offset = 0;
  std::uint64_t data_offset = 0;  ///< at most the size of the file

  ByteOrder order() const { return type[0] == '>' ? ByteOrder::big : ByteOrder::little; }
  /// Of one number.
  std::size_t bytes() const { return static_cast<std::size_t>(type[2] - '0'); }
  /// Whether the numbers are of one of these kinds: 'f' floating-point, 'i' and 'u' integers, 'b' truth.
  bool is_of(std::string_view kinds) const { return kinds.find(type[1]) != std::string_view::npos; }
};

/// Reads format versions 1.0, 2.0 and 3.0. The header's dictionary may come in any order and spacing that
/// Python reads; it must have exactly the three keys of the format. Errors: bad_input naming the byte offset,
/// also for what NumPy would read and this project does not: types other than numbers of 1 to 8 bytes and
/// truth values, and Fortran order.
Result<NpyHeader> parse_npy_header(std::span<const std::byte> file);

/// The bytes before the data of a version 1.0 file, padded as NumPy does.
std::string npy_header_bytes(std::string_view type, std::span<const std::uint64_t> shape);

}  // namespace cellsweep
