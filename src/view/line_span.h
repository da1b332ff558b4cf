/// @file
/// Which part of a ray lies in a box, for what is drawn and grabbed: as exact as floats are.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>

namespace cellsweep::view {

/// From one time to another, in lengths of the direction.
struct LineSpan {
  float first = 0;
  float last = std::numeric_limits<float>::infinity();
};

/// Nothing where the ray passes the box.
inline std::optional<LineSpan> span_in(const Eigen::AlignedBox3f& box, const Eigen::Vector3f& origin,
                                       const Eigen::Vector3f& direction) {
  LineSpan span;
  for (int axis = 0; axis < 3; ++axis) {
    const float before = box.min()[axis] - origin[axis];
    const float behind = box.max()[axis] - origin[axis];
    if (direction[axis] == 0) {
      if (before > 0 || behind < 0) return std::nullopt;
      continue;
    }
    const auto [in, out] = std::minmax({before / direction[axis], behind / direction[axis]});
    span = {std::max(span.first, in), std::min(span.last, out)};
  }
  if (span.first > span.last) return std::nullopt;
  return span;
}

}  // namespace cellsweep::view
