/// @file
/// The arrays of a trace as its archive has them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/status.h"
#include "world/files/npy_header.h"
#include "world/files/zip_archive.h"

namespace cellsweep {

/// A member's name is an array's and this.
inline constexpr std::string_view kNpyEnding = ".npy";

/// One number a row, or six.
struct NpzArray {
  std::vector<std::byte> bytes;  ///< a whole .npy, as long as its header says
  NpyHeader header;
  std::uint64_t rows = 0;
  std::uint64_t row_bytes = 0;

  bool is_there() const { return !bytes.empty(); }
  /// Where in the .npy a row begins.
  std::uint64_t offset_of(std::uint64_t row) const { return header.data_offset + row * row_bytes; }
};

/// "moved.npy, byte 128: ...", for a status of one array.
Status in_array(std::string_view name, Status status);

/// Those that trace.h lists, each there once with the type and the shape that it should have; the filters'
/// may all be missing.
class NpzArrays {
 public:
  /// Errors: bad_input, with the array's name in front where it is of one.
  Status take_all(std::vector<ZipMember> members);

  const NpzArray& operator[](std::string_view name) const { return arrays_[place_of(name)]; }

 private:
  static constexpr std::size_t kCount = 11;
  static std::size_t place_of(std::string_view name);
  Status take(ZipMember member);

  std::array<NpzArray, kCount> arrays_;
};

}  // namespace cellsweep
