/// @file
/// Arrays of values and IDs for the tests of cell-paper's steps: whole vectors, aligned as in a local store.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/wire.h"

namespace cellsweep::cell {

/// Values with an ID each, padded as C2 says.
struct TrackedArray {
  TrackedArray(const std::vector<float>& given_values, const std::vector<std::uint32_t>& given_ids)
      : values(given_values.begin(), given_values.end()), ids(given_ids.begin(), given_ids.end()) {
    const std::size_t padded = round_up(static_cast<std::uint32_t>(values.size()), kLanes);
    values.resize(padded, std::bit_cast<float>(kPaddingValueBits));
    ids.resize(padded, kUnchanged);
  }

  /// IDs 1, 2, 3 …
  explicit TrackedArray(const std::vector<float>& given_values)
      : TrackedArray(given_values, counted(given_values)) {}

  std::uint32_t count() const { return static_cast<std::uint32_t>(values.size()); }
  std::uint32_t vectors() const { return count() / kLanes; }

  /// Values with their IDs, ascending by both: equal for arrays that are permutations of each other.
  std::vector<std::pair<float, std::uint32_t>> sorted_pairs() const {
    std::vector<std::pair<float, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < values.size(); ++i) pairs.emplace_back(values[i], ids[i]);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  static std::vector<std::uint32_t> counted(const std::vector<float>& of) {
    std::vector<std::uint32_t> numbers;
    for (std::size_t i = 0; i < of.size(); ++i) numbers.push_back(static_cast<std::uint32_t>(i + 1));
    return numbers;
  }

  DmaVector<float> values;
  DmaVector<std::uint32_t> ids;
};

}  // namespace cellsweep::cell
