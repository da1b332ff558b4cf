/// @file
/// Sorts pair keys by distribution: the first body's number chooses the place, few comparisons are left.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/array.h"
#include "base/threads/crew.h"
#include "cellsweep/engine/slots.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// Keys of pairs, the first body's number above the second's, as several workers found them.
using KeyParts = std::span<const std::span<const std::uint64_t>>;

/// How many there are in all parts.
inline std::size_t count_keys(KeyParts parts) {
  std::size_t count = 0;
  for (const auto part : parts) count += part.size();
  return count;
}

/// Writes all keys, which differ, to `sorted` in ascending order. `AnyPair` is Pair or SlotPair. `scratch` is
/// working memory.
template <class AnyPair>
void sort_pairs(Crew& crew, KeyParts parts, Array<std::uint64_t>& scratch, Array<AnyPair>& sorted);

/// The same a part at a time, for many keys that are in buckets (KeyBuckets) in `scratch`, which begin there:
/// so many of the buckets, from the first on, are written to `sorted`, which has room for all keys.
template <class AnyPair>
void sort_buckets(Crew& crew, std::span<const std::size_t> begins, std::size_t first, std::size_t count,
                  Array<std::uint64_t>& scratch, Array<AnyPair>& sorted);
/// Whether keys are so many that this is of use.
bool are_sorted_in_parts(std::size_t keys);

}  // namespace cellsweep
