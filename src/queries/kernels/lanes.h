/// @file
/// One question in the lanes of any vector, against rows of boxes: `Lanes` says how wide a vector is, gathers
/// and compares.
///
/// As in the kernels of engine `stream`, whatever these call has internal linkage and nothing of it is the
/// standard library's: engines/stream/kernels/body.h says why.
///
/// Rounding: an operation is off by 2^-24 of its result, and at most six follow each other, so a path's times
/// are made smaller or larger by 2^-19 of themselves (kSmaller, kLarger). That a number overflows, or is too
/// small for a normal one, must make no box be missed either: what is too large is taken to be kLargest, and
/// kSmallest is added. Squares of distances are compared with numbers that allow for all that.
#pragma once

#include "cellsweep/engine/cell_boxes.h"
#include "queries/kernels/kernel.h"

namespace cellsweep::queries {
namespace {

inline constexpr float kLargest = 1e38F;
inline constexpr float kSmallest = 1e-37F;

template <class Lanes>
using VectorOf = typename Lanes::Vector;

template <class Lanes>
VectorOf<Lanes> all(float value) {
  return value - VectorOf<Lanes>{};
}

// Where an operand is NaN, the second one is the result. Where that is 0, GCC makes a comparison and a choice
// of it, for which there is Lanes::not_negative().
template <class Vector>
Vector larger(Vector a, Vector b) {
  return a > b ? a : b;
}
template <class Vector>
Vector smaller(Vector a, Vector b) {
  return a < b ? a : b;
}

/// Calls `test(faces)` with each vector of boxes and appends the places of the lanes that it returns.
template <class Lanes, class Test>
std::uint32_t find_places(const BoxRow& row, std::uint32_t* places, const Test& test) {
  std::uint32_t found = 0;
  for (std::uint32_t first = 0; first < row.count; first += Lanes::kCount) {
    VectorOf<Lanes> faces[6];
    Lanes::gather(row.first + first * row.step, row.step, row.count - first, faces);
    const std::uint32_t lanes = test(faces) & Lanes::lanes_below(row.count - first);
    found += Lanes::put_places(lanes, first, places + found);
  }
  return found;
}

/// A box in all lanes.
template <class Lanes>
struct OverlapLanes {
  VectorOf<Lanes> low[3], high[3];

  explicit OverlapLanes(const Aabb& box) {
    const auto* const face = reinterpret_cast<const float*>(&box);
    for (unsigned axis = 0; axis < 3; ++axis) {
      low[axis] = all<Lanes>(face[axis]);
      high[axis] = all<Lanes>(face[axis + 3]);
    }
  }

  /// A bit for each lane whose box overlaps it.
  std::uint32_t test(const VectorOf<Lanes> (&faces)[6]) const {
    auto meets = Lanes::less_equal(faces[0], high[0]);
    meets = meets & Lanes::less_equal(low[0], faces[3]);
    for (unsigned axis = 1; axis < 3; ++axis) {
      meets = meets & Lanes::less_equal(faces[axis], high[axis]);
      meets = meets & Lanes::less_equal(low[axis], faces[axis + 3]);
    }
    return Lanes::bits(meets);
  }
};

template <class Lanes>
std::uint32_t find_overlaps(const BoxRow& row, const Aabb& box, std::uint32_t* places) {
  const OverlapLanes<Lanes> lanes(box);
  return find_places<Lanes>(row, places, [&](const auto& faces) { return lanes.test(faces); });
}

/// The numbers of a path in all lanes. `kFlat`: there may be an axis along which the path does not move; a
/// box must reach above `low` there, and below `high`.
template <class Lanes, bool kFlat>
struct CastLanes {
  VectorOf<Lanes> from_min[3], from_max[3], inverse[3], wide[3], low[3], high[3];
  VectorOf<Lanes> end;

  explicit CastLanes(const CastNumbers& path) : end(all<Lanes>(path.end)) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const bool goes_up = path.near[axis] < path.far[axis];
      from_min[axis] = all<Lanes>(goes_up ? path.front[axis] : path.back[axis]);
      from_max[axis] = all<Lanes>(goes_up ? path.back[axis] : path.front[axis]);
      inverse[axis] = all<Lanes>(-path.sooner[axis]);
      if (!kFlat) continue;
      const bool is_flat = path.sooner[axis] == -__builtin_inff();
      wide[axis] = all<Lanes>(is_flat ? __builtin_inff() : 0);
      low[axis] = all<Lanes>(is_flat ? path.back[axis] : -__builtin_inff());
      high[axis] = all<Lanes>(is_flat ? path.front[axis] : __builtin_inff());
    }
  }

  /// A bit for each lane whose box the path may touch.
  std::uint32_t test(const VectorOf<Lanes> (&faces)[6]) const {
    using Vector = VectorOf<Lanes>;
    Vector enter = {};
    Vector leave = end;
    auto meets = Lanes::less_equal(faces[0], faces[3]);
    for (unsigned axis = 0; axis < 3; ++axis) {
      const Vector a = (faces[axis] - from_min[axis]) * inverse[axis];
      const Vector b = (faces[axis + 3] - from_max[axis]) * inverse[axis];
      Vector first = smaller(a, b);
      Vector last = larger(a, b);
      if (kFlat) {
        first = first - wide[axis];
        last = last + wide[axis];
        meets = meets & Lanes::less_equal(faces[axis], high[axis]);
        meets = meets & Lanes::less_equal(low[axis], faces[axis + 3]);
      }
      enter = larger(first, enter);
      leave = smaller(last, leave);
    }
    enter = smaller(enter, all<Lanes>(kLargest)) * kSmaller;
    constexpr float kLater = kLarger * kLarger;  // the inverses are too small already
    return Lanes::bits(meets & Lanes::less_equal(enter, leave * kLater + kSmallest));
  }
};

template <class Lanes, bool kFlat>
std::uint32_t find_on_path_that(const BoxRow& row, const CastNumbers& path, std::uint32_t* places) {
  const CastLanes<Lanes, kFlat> lanes(path);
  return find_places<Lanes>(row, places, [&](const auto& faces) { return lanes.test(faces); });
}

template <class Lanes>
std::uint32_t find_on_path(const BoxRow& row, const CastNumbers& path, std::uint32_t* places) {
  return path.is_flat ? find_on_path_that<Lanes, true>(row, path, places)
                      : find_on_path_that<Lanes, false>(row, path, places);
}

/// The numbers of a near question in all lanes.
template <class Lanes>
struct NearLanes {
  VectorOf<Lanes> min[3], max[3];
  VectorOf<Lanes> most;

  explicit NearLanes(const NearNumbers& question) : most(all<Lanes>(question.most)) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      min[axis] = all<Lanes>(question.min[axis]);
      max[axis] = all<Lanes>(question.max[axis]);
    }
  }

  /// A bit for each lane whose box may be near enough, and the square of its distance.
  std::uint32_t test(const VectorOf<Lanes> (&faces)[6], VectorOf<Lanes>& square) const {
    using Vector = VectorOf<Lanes>;
    const auto square_on = [&](unsigned axis) {
      const Vector gap = larger(faces[axis] - max[axis], min[axis] - faces[axis + 3]);
      const Vector there = Lanes::not_negative(gap);
      return there * there;
    };
    square = square_on(0) + square_on(1) + square_on(2);
    return Lanes::bits(Lanes::less_equal(faces[0], faces[3]) & Lanes::less_equal(square, most));
  }
};

inline std::uint64_t near_key(float square, std::uint32_t place) {
  return std::uint64_t{__builtin_bit_cast(std::uint32_t, square)} << 32 | place;
}

template <class Lanes>
std::uint32_t find_near(const BoxRow& row, const NearNumbers& question, std::uint64_t* keys) {
  const NearLanes<Lanes> question_lanes(question);
  std::uint32_t found = 0;
  for (std::uint32_t first = 0; first < row.count; first += Lanes::kCount) {
    VectorOf<Lanes> faces[6];
    VectorOf<Lanes> square;
    Lanes::gather(row.first + first * row.step, row.step, row.count - first, faces);
    std::uint32_t lanes = question_lanes.test(faces, square) & Lanes::lanes_below(row.count - first);
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(lanes));
      const float lower = square[lane];  // clang 14 casts the bits of the first lane, if not of a copy
      keys[found++] = near_key(lower, first + Lanes::place_of(lane));
    }
  }
  return found;
}

/// What lanes in the order of the boxes have in common.
template <unsigned kLanes>
struct LanesInOrder {
  static constexpr unsigned kCount = kLanes;

  /// A bit for each lane below `count`.
  static std::uint32_t lanes_below(std::uint32_t count) {
    return count >= kCount ? (1U << kCount) - 1 : (1U << count) - 1;
  }
  /// The place in the vector of a lane's box.
  static std::uint32_t place_of(unsigned lane) { return lane; }
  static std::uint32_t put_places(std::uint32_t lanes, std::uint32_t first, std::uint32_t* places) {
    std::uint32_t count = 0;
    for (; lanes != 0; lanes &= lanes - 1)
      places[count++] = first + static_cast<unsigned>(__builtin_ctz(lanes));
    return count;
  }
};

}  // namespace
}  // namespace cellsweep::queries
