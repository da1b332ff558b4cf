/// @file
/// An array of a trace, read from its first row to its last.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/status.h"
#include "world/files/npz_arrays.h"
#include "world/files/zip_archive.h"

namespace cellsweep {

/// Rows of which each is asked for once, in their order; no more than there are. Errors of all: bad_input,
/// with the array's name and the byte in front.
class ArrayStream {
 public:
  static Result<ArrayStream> open(const ZipArchive& archive, std::string_view name, const NpzArray& array);

  /// The next numbers, none above `most`.
  template <class Number>
  Status read(std::uint64_t count, std::uint64_t most, std::vector<Number>& numbers) {
    numbers.clear();
    while (count > 0) {
      if (Status status = read_part(count, most); !status.ok()) return status;
      for (const std::uint64_t number : part_) numbers.push_back(static_cast<Number>(number));
      count -= part_.size();
    }
    return {};
  }
  /// The next boxes, finite with min <= max.
  Status read(std::uint64_t count, std::vector<Aabb>& boxes);

  /// After the last row: the checksum is right.
  Status finish();

 private:
  ArrayStream(ZipStream stream, std::string_view name, const NpzArray& array)
      : stream_(std::move(stream)), name_(name), array_(&array) {}

  /// Fills `part_` with up to so many.
  Status read_part(std::uint64_t count, std::uint64_t most);
  /// The bytes of the next rows, some of up to so many.
  Result<std::span<const std::byte>> next_rows(std::uint64_t count);
  Status skip_header();

  ZipStream stream_;
  std::string_view name_;
  const NpzArray* array_;
  std::uint64_t row_ = 0;        // the next
  std::vector<std::byte> held_;  // read from the stream and not asked for yet, from here on:
  std::size_t begin_ = 0;
  std::vector<std::uint64_t> part_;
};

}  // namespace cellsweep
