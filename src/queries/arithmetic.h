/// @file
/// What query.h says of times and distances, to the last bit: every answer is decided by these functions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "cellsweep/query.h"
#include "geometry/canonical.h"

namespace cellsweep::queries {

/// The gap between two intervals on an axis; 0 where they meet.
inline double gap_on(const Aabb& one, const Aabb& other, std::size_t axis) {
  const double above = double{one.min[axis]} - other.max[axis];
  const double below = double{other.min[axis]} - one.max[axis];
  return std::max(std::max(above, below), 0.0);
}

inline double distance_of(const Aabb& one, const Aabb& other) {
  const double x = gap_on(one, other, 0);
  const double y = gap_on(one, other, 1);
  const double z = gap_on(one, other, 2);
  return std::sqrt(x * x + y * y + z * z);
}

/// The faces of boxes by their numbers, minima by axis and then maxima: of one that lies by itself.
inline double face_of(const Aabb& box, std::size_t number) {
  return reinterpret_cast<const float*>(&box)[number];
}

/// A path, and when it touches boxes.
class Cast {
 public:
  /// What the path has on an axis at the side that comes to boxes first, and behind; and the sides at which
  /// it comes to them and leaves them, as numbers of faces, so that nothing has to be chosen at each box.
  struct Axis {
    explicit Axis(const Path& path, std::size_t axis)
        : low(canonical(path.box.min[axis])),
          high(canonical(path.box.max[axis])),
          direction(path.direction[axis]) {
      using Two [[gnu::vector_size(16)]] = double;
      const Two up = {high, low};
      const Two down = {low, high};
      const Two sides = Two{direction, direction} < 0 ? down : up;
      front = sides[0];
      back = sides[1];
      const std::size_t goes_down = direction < 0 ? 1 : 0;
      near = axis + 3 * goes_down;
      far = axis + 3 * (1 - goes_down);
      if (has_inverse(direction)) inverse = 1 / direction;
    }

    /// It moves there, so slowly that nothing is known without a division.
    bool creeps() const { return inverse == 0 && direction != 0; }

    float low;
    float high;
    double direction;
    double inverse = 0;  ///< of the direction; 0 where that is 0, or nearly so
    double front;
    double back;
    std::size_t near;
    std::size_t far;
  };

  /// Whether no time of a touch, a gap between floats over the direction, overflows.
  static bool has_inverse(double direction) { return std::fabs(direction) > 0x1p-500; }

  explicit Cast(const Path& path)
      : axes_{Axis(path, 0), Axis(path, 1), Axis(path, 2)},
        end_(path.end),
        creeps_(axes_[0].creeps() || axes_[1].creeps() || axes_[2].creeps()) {}

  const Axis& axis(std::size_t axis) const { return axes_[axis]; }
  double end() const { return end_; }

  /// When the path touches a box first, if it does up to `end`. A box is whatever face_of() takes.
  template <class Box>
  std::optional<double> touch(const Box& box, double end) const {
    const Times times = about(box, end);
    if (misses(times)) return std::nullopt;
    return touches_for_certain(times) ? first_time(times, box) : touch_exactly(box, end);
  }

  /// Whether touch() finds a time.
  template <class Box>
  bool touches(const Box& box, double end) const {
    const Times times = about(box, end);
    if (misses(times)) return false;
    return touches_for_certain(times) || touch_exactly(box, end).has_value();
  }

 private:
  static constexpr double kSlack = 0x1p-51;

  /// When a path has come to a box on each axis and on all, what it has to go until then, and when it has
  /// left it on one.
  struct Times {
    double enters[3];
    double gaps[3];
    double enter;
    double leave;
  };

  // What the path has to go until it meets a box, and until it has passed it.
  template <class Box>
  static double gap_before(const Axis& axis, const Box& box) {
    return face_of(box, axis.near) - axis.front;
  }
  template <class Box>
  static double gap_behind(const Axis& axis, const Box& box) {
    return face_of(box, axis.far) - axis.back;
  }

  template <class Box>
  std::optional<double> touch_exactly(const Box& box, double end) const {
    double enter = 0;
    double leave = end;
    double first = 0;
    for (const Axis& axis : axes_) {
      const double d = axis.direction;
      const double before = gap_before(axis, box);
      const double behind = gap_behind(axis, box);
      if (d == 0) {
        if (before > 0 || behind < 0) return std::nullopt;
        continue;
      }
      const double from = before / d;
      first = std::max(first, from);
      enter = std::max(enter, earlier(from, kSlack));
      leave = std::min(leave, later(behind / d, kSlack));
    }
    if (enter > leave) return std::nullopt;
    return first;
  }

  // Without a division: off by less than kSlack. A box beside the path, where that stays on an axis, is left
  // before it is come to.
  template <class Box>
  Times about(const Box& box, double end) const {
    Times times{{}, {}, 0, end};
    for (std::size_t k = 0; k < 3; ++k) {
      const Axis& axis = axes_[k];
      if (axis.inverse == 0) {
        if (axis.direction == 0 && (gap_before(axis, box) > 0 || gap_behind(axis, box) < 0)) times.leave = -1;
        continue;
      }
      times.gaps[k] = gap_before(axis, box);
      times.enters[k] = times.gaps[k] * axis.inverse;
      times.enter = std::max(times.enter, times.enters[k]);
      times.leave = std::min(times.leave, gap_behind(axis, box) * axis.inverse);
    }
    return times;
  }

  // Nearly all boxes that it does not touch.
  static bool misses(const Times& about) {
    return about.leave < 0 || about.enter * (1 - 2 * kSlack) > about.leave * (1 + 2 * kSlack);
  }

  // Most boxes that it does touch.
  bool touches_for_certain(const Times& about) const {
    return !creeps_ && about.enter * (1 + 2 * kSlack) <= about.leave * (1 - 2 * kSlack);
  }

  // When the path comes to a box on the axis on which it does last. Only where it does at nearly the same
  // time on another one it takes divisions to tell which that is.
  template <class Box>
  double first_time(const Times& about, const Box& box) const {
    const auto& [x, y, z] = about.enters;
    const double second = std::max(std::min(x, y), std::min(std::max(x, y), z));
    if (second >= about.enter * (1 - 2 * kSlack)) return first_exactly(box);
    // Which axis that is nobody could foretell: no branch depends on it.
    using Way [[gnu::vector_size(16)]] = double;
    const auto way = [&](std::size_t axis) { return Way{about.gaps[axis], axes_[axis].direction}; };
    const auto both = [](double number) { return Way{number, number}; };
    const Way of_two = both(y) > both(x) ? way(1) : way(0);
    const Way last = both(z) > both(std::max(x, y)) ? way(2) : of_two;
    return std::max(0.0, last[0] / last[1]);
  }

  template <class Box>
  double first_exactly(const Box& box) const {
    double first = 0;
    for (const Axis& axis : axes_) {
      if (axis.direction != 0) first = std::max(first, gap_before(axis, box) / axis.direction);
    }
    return first;
  }

  static double earlier(double time, double slack) { return time * (time > 0 ? 1 - slack : 1 + slack); }
  static double later(double time, double slack) { return time * (time > 0 ? 1 + slack : 1 - slack); }

  std::array<Axis, 3> axes_;
  double end_;
  bool creeps_;  // on one of them
};

}  // namespace cellsweep::queries
