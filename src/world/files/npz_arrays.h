/// @file
/// The arrays of a trace as its archive has them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "cellsweep/status.h"
#include "world/files/npy_header.h"
#include "world/files/zip_archive.h"

namespace cellsweep {

/// A member's name is an array's and this.
inline constexpr std::string_view kNpyEnding = ".npy";

/// One number a row, or six.
struct NpzArray {
  std::size_t member = 0;  ///< of the archive
  NpyHeader header;
  std::uint64_t rows = 0;
  std::uint64_t row_bytes = 0;  ///< 0 for an array that is not there

  bool is_there() const { return row_bytes != 0; }
  /// Where in the .npy a row begins.
  std::uint64_t offset_of(std::uint64_t row) const { return header.data_offset + row * row_bytes; }
};

/// "moved.npy, byte 128: ...", for a status of one array.
Status in_array(std::string_view name, Status status);

/// Those that trace.h lists, each there once with the type, the shape and the length that it should have; the
/// filters' may all be missing.
class NpzArrays {
 public:
  /// Reads their headers. Errors: bad_input, with the array's name in front where it is of one.
  Status read_headers(const ZipArchive& archive);

  const NpzArray& operator[](std::string_view name) const { return arrays_[place_of(name)]; }
  bool has_filters() const { return (*this)["category"].is_there(); }

 private:
  static constexpr std::size_t kCount = 11;
  static std::size_t place_of(std::string_view name);
  Status take(const ZipArchive& archive, std::size_t member);
  Status check_all_there() const;
  Status check_lengths() const;

  std::array<NpzArray, kCount> arrays_;
};

}  // namespace cellsweep
