/// @file
/// The interval on one axis that encloses a turned box, four boxes at a time, rounded outwards (F3).
#pragma once

#include "engines/cell/resident_wire.h"
#include "engines/cell/spu/resident/round_up.h"

namespace cellsweep::cell {

struct PoseVectors {
  vec_float4 orientation[4];
  vec_float4 half_extents[3];
  vec_float4 centre[3];
};
static_assert(sizeof(PoseVectors) == sizeof(PoseBlock));

struct IntervalVectors {
  vec_float4 low;
  vec_float4 high;
};
static_assert(sizeof(IntervalVectors) == sizeof(IntervalBlock));

/// |a·b + c·d|, at least.
inline vec_float4 crossed_up(vec_float4 a, vec_float4 b, vec_float4 c, vec_float4 d) {
  const Product left = product(a, b);
  const Product right = product(c, d);
  const vec_float4 sum = magnitude_of_sum_up(left.value, right.value);
  return magnitude_of_sum_up(magnitude_of_sum_up(sum, left.error), right.error);
}

/// |a² + b² − c² − d²|, at least.
inline vec_float4 squares_apart_up(vec_float4 a, vec_float4 b, vec_float4 c, vec_float4 d) {
  const vec_float4 plus = magnitude_of_sum_up(product_up(a, a), product_up(b, b));
  const vec_float4 minus = magnitude_of_sum_up(product_up(c, c), product_up(d, d));
  const vec_float4 plus_truncated = spu_madd(a, a, spu_mul(b, b));
  const vec_float4 minus_truncated = spu_madd(c, c, spu_mul(d, d));
  return greater(magnitude_of_sum_up(plus, negative(minus_truncated)),
                 magnitude_of_sum_up(minus, negative(plus_truncated)));
}

/// How far the turned box reaches from its centre along the axis, at least. The rotation matrix of a
/// quaternion, times its squared length, is sums of products; the axis' row is taken with the axes in turn,
/// so that the code is the same for all.
inline vec_float4 reach_up(const PoseVectors& pose, unsigned int axis) {
  const unsigned int next = (axis + 1) % 3;
  const unsigned int last = (axis + 2) % 3;
  const vec_float4 i = pose.orientation[axis];
  const vec_float4 j = pose.orientation[next];
  const vec_float4 k = pose.orientation[last];
  const vec_float4 w = pose.orientation[3];
  const vec_float4 own = squares_apart_up(w, i, j, k);
  const vec_float4 to_next = crossed_up(i, j, negative(w), k);
  const vec_float4 to_last = crossed_up(i, k, w, j);
  const vec_float4 aside = magnitude_of_sum_up(product_up(to_next, pose.half_extents[next]),
                                               product_up(to_last, pose.half_extents[last]));
  const vec_float4 scaled =
      magnitude_of_sum_up(product_up(own, pose.half_extents[axis]), spu_add(aside, aside));
  const vec_float4 length_truncated = spu_madd(w, w, spu_madd(i, i, spu_madd(j, j, spu_mul(k, k))));
  return quotient_up(scaled, length_truncated);
}

inline IntervalVectors enclose(const PoseVectors& pose, unsigned int axis) {
  const vec_float4 reach = reach_up(pose, axis);
  const vec_float4 low = sum_up(negative(pose.centre[axis]), reach);
  // No box has a −0.
  return {spu_sel(negative(low), zeros(), spu_cmpeq(low, zeros())), sum_up(pose.centre[axis], reach)};
}

}  // namespace cellsweep::cell
