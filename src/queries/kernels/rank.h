/// @file
/// The places of a few numbers in their order: each is compared with all others, and no branch depends on
/// them.
#pragma once

#include "queries/kernels/kernel.h"

namespace cellsweep::queries {
namespace {

/// How many of the numbers are less than each. The vectors of a block share a number that is compared with
/// them.
template <unsigned kLanes>
void rank(const std::int32_t* numbers, std::uint32_t count, std::uint32_t* places) {
  using Numbers [[gnu::vector_size(4 * kLanes)]] = std::int32_t;
  constexpr std::uint32_t kVectors = 4;
  static_assert(kVectors * kLanes <= kRankedAtOnce);
  // One at a time: what is copied into an array of vectors goes through memory, in halves.
  const auto load = [=](std::uint32_t from) {
    Numbers vector;
    __builtin_memcpy(&vector, numbers + from, sizeof(vector));
    return vector;
  };
  const auto store = [=](std::uint32_t to, const Numbers& vector) {
    __builtin_memcpy(places + to, &vector, sizeof(vector));
  };
  for (std::uint32_t first = 0; first < count; first += kVectors * kLanes) {
    Numbers block[kVectors];
    Numbers less[kVectors] = {};
    for (std::uint32_t vector = 0; vector < kVectors; ++vector) block[vector] = load(first + vector * kLanes);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Numbers number = numbers[i] - Numbers{};
      for (std::uint32_t vector = 0; vector < kVectors; ++vector) less[vector] -= number < block[vector];
    }
    for (std::uint32_t vector = 0; vector < kVectors; ++vector) store(first + vector * kLanes, less[vector]);
  }
}

}  // namespace
}  // namespace cellsweep::queries
