#include "engines/cell/spu/paper/intervector_sort.h"

namespace cellsweep::cell::paper {
namespace {

/// Elements 1, 2, 3, 4 become 4, 1, 2, 3.
const vec_uchar16 kRotate = {12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};

inline void rotate(Tracked& tracked) {
  tracked.values = vec_perm(tracked.values, tracked.values, kRotate);
  tracked.ids = vec_perm(tracked.ids, tracked.ids, kRotate);
}

inline vec_uint4 pick(vec_uint4 kept, vec_uint4 other, vec_uint4 keep_mask) {
  const vec_uint4 change_mask = vec_nor(keep_mask, keep_mask);
  return vec_or(vec_and(kept, keep_mask), vec_and(other, change_mask));
}

inline void split_lanes_inline(Tracked& low, Tracked& high) {
  const vec_float4 max_values = vec_max(low.values, high.values);
  const vec_float4 min_values = vec_min(low.values, high.values);
  const auto max_mask = (vec_uint4)vec_cmpeq(max_values, high.values);
  const auto min_mask = (vec_uint4)vec_cmpeq(min_values, low.values);
  const vec_uint4 max_ids = pick(high.ids, low.ids, max_mask);
  const vec_uint4 min_ids = pick(low.ids, high.ids, min_mask);
  high = {max_values, max_ids};
  low = {min_values, min_ids};
}

inline void split_inline(Tracked& low, Tracked& high) {
  for (int step = 0; step < 4; ++step) {
    split_lanes_inline(low, high);
    rotate(low);
  }
}

/// True when some element of `one` is greater than some element of `other`.
inline bool any_above(vec_float4 one, vec_float4 other) {
  auto above = (vec_uint4)vec_cmpgt(one, other);
  for (int step = 1; step < 4; ++step) {
    other = vec_perm(other, other, kRotate);
    above = vec_or(above, (vec_uint4)vec_cmpgt(one, other));
  }
  return spu_extract(spu_gather(above), 0) != 0;
}

}  // namespace

void split_lanes(Tracked& low, Tracked& high) {
  split_lanes_inline(low, high);
}

void split(Tracked& low, Tracked& high) {
  split_inline(low, high);
}

void intervector_sort(float* values, std::uint32_t* ids, std::uint32_t vectors, EarlyOut early_out) {
  for (std::uint32_t i = 1; i < vectors; ++i) {
    Tracked inserted = load(values, ids, i);
    std::uint32_t j = i;
    for (; j > 0; --j) {
      Tracked neighbour = load(values, ids, j - 1);
      if (early_out == EarlyOut::yes && !any_above(neighbour.values, inserted.values)) break;
      split_inline(inserted, neighbour);
      store(neighbour, values, ids, j);
    }
    store(inserted, values, ids, j);
  }
}

}  // namespace cellsweep::cell::paper
