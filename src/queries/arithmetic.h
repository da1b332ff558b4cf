/// @file
/// What query.h says of times and distances, to the last bit: every answer is decided by these functions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "cellsweep/query.h"

namespace cellsweep::queries {

/// The gap between two intervals on an axis; 0 where they meet.
inline double gap_on(const Aabb& one, const Aabb& other, std::size_t axis) {
  const double above = double{one.min[axis]} - other.max[axis];
  const double below = double{other.min[axis]} - one.max[axis];
  return std::max({above, below, 0.0});
}

inline double distance_of(const Aabb& one, const Aabb& other) {
  const double x = gap_on(one, other, 0);
  const double y = gap_on(one, other, 1);
  const double z = gap_on(one, other, 2);
  return std::sqrt(x * x + y * y + z * z);
}

/// A path, and when it touches boxes.
class Cast {
 public:
  explicit Cast(const Path& path) : path_(path) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d = path.direction[axis];
      if (std::fabs(d) > 0x1p-500) inverse_[axis] = 1 / d;
    }
  }

  const Path& path() const { return path_; }

  /// When the path touches a box first, if it does up to `end`.
  std::optional<double> touch(const Aabb& box, double end) const {
    if (misses(box, end)) return std::nullopt;
    return touch_exactly(box, end);
  }

 private:
  static constexpr double kSlack = 0x1p-51;

  /// What the path has to go on an axis until it meets a box, and until it has passed it, when it goes up.
  struct Gaps {
    double before;
    double behind;
  };
  Gaps gaps_on(const Aabb& box, std::size_t axis) const {
    return {double{box.min[axis]} - path_.box.max[axis], double{box.max[axis]} - path_.box.min[axis]};
  }

  std::optional<double> touch_exactly(const Aabb& box, double end) const {
    double enter = 0;
    double leave = end;
    double first = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d = path_.direction[axis];
      const Gaps gaps = gaps_on(box, axis);
      if (d == 0) {
        if (gaps.before > 0 || gaps.behind < 0) return std::nullopt;
        continue;
      }
      const double from = (d > 0 ? gaps.before : gaps.behind) / d;
      first = std::max(first, from);
      enter = std::max(enter, earlier(from, kSlack));
      leave = std::min(leave, later((d > 0 ? gaps.behind : gaps.before) / d, kSlack));
    }
    if (enter > leave) return std::nullopt;
    return first;
  }

  // Nearly all boxes that it does not touch, without a division.
  bool misses(const Aabb& box, double end) const {
    double enter = 0;
    double leave = end;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (inverse_[axis] == 0) continue;
      const Gaps gaps = gaps_on(box, axis);
      const double one = gaps.before * inverse_[axis];
      const double other = gaps.behind * inverse_[axis];
      const double from = one < other ? one : other;
      const double to = one < other ? other : one;
      enter = from > enter ? from : enter;
      leave = to < leave ? to : leave;
    }
    return leave < 0 || enter * (1 - 2 * kSlack) > leave * (1 + 2 * kSlack);
  }

  static double earlier(double time, double slack) { return time * (time > 0 ? 1 - slack : 1 + slack); }
  static double later(double time, double slack) { return time * (time > 0 ? 1 + slack : 1 - slack); }

  Path path_;
  std::array<double, 3> inverse_{};  // of the direction, but where that is 0 or nearly so
};

}  // namespace cellsweep::queries
