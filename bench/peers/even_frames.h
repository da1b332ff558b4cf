/// @file
/// How even frames are, whatever the machine does besides.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "report/quantile.h"

namespace cellsweep::bench {

/// Seconds of a frame in which the system took the core away.
inline constexpr double kDisturbed = std::numeric_limits<double>::infinity();

/// Of each frame what it took in the middle one of three runs through the same world: what befell one of them
/// was the machine's, and what the world asks for comes in all. Without those that were disturbed in two.
inline std::vector<double> middle_of(const std::array<std::vector<double>, 3>& runs) {
  std::vector<double> frames;
  for (std::size_t i = 0; i < runs[0].size(); ++i) {
    const double middle = report::quantile({runs[0][i], runs[1][i], runs[2][i]}, 0.5);
    if (middle != kDisturbed) frames.push_back(middle);
  }
  return frames;
}

/// Each frame over the median of some hundred around it: a world that dissolves takes less with each frame,
/// and that is not uneven.
inline std::vector<double> over_medians_nearby(std::span<const double> frames) {
  constexpr std::size_t kNearby = 101;
  const std::size_t count = std::min(kNearby, frames.size());
  std::vector<double> ratios;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::size_t first = std::min(i - std::min(i, count / 2), frames.size() - count);
    const auto nearby = frames.subspan(first, count);
    ratios.push_back(frames[i] / report::quantile({nearby.begin(), nearby.end()}, 0.5));
  }
  return ratios;
}

}  // namespace cellsweep::bench
