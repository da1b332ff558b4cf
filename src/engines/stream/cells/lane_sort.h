/// @file
/// Sorts the numbers of three axes at once.
#pragma once

#include <bit>
#include <cstddef>
#include <span>
#include <utility>

#include "geometry/box_lanes.h"

namespace cellsweep::stream {

/// Ascending, each lane by itself. A sorting network (Batcher's merge exchange): which numbers are compared
/// does not depend on them, so that no branch is mispredicted. For some dozens of finite numbers: of 128 in
/// three lanes std::sort takes ten times as long. Not inlined: that would be a kilobyte for each caller.
[[gnu::noinline]] inline void sort_lanes(std::span<Float4> numbers) {
  const std::size_t count = numbers.size();
  if (count < 2) return;
  Float4* const lane = numbers.data();
  const auto compare_runs = [=](std::size_t first, std::size_t run, std::size_t distance) {
    for (; first + distance < count; first += 2 * run) {
      const std::size_t end = first + run + distance < count ? first + run : count - distance;
      for (std::size_t i = first; i < end; ++i) {
        const Float4 one = lane[i];
        const Float4 other = lane[i + distance];
        lane[i] = one < other ? one : other;
        lane[i + distance] = one < other ? other : one;
      }
    }
  };
  const std::size_t top = std::bit_ceil(count) / 2;
  for (std::size_t run = top; run > 0; run /= 2) {
    compare_runs(0, run, run);
    for (std::size_t far = top; far > run; far /= 2) compare_runs(run, run, far - run);
  }
}

}  // namespace cellsweep::stream
