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

inline bool stays(const Tracked& inserted, const Tracked& neighbour, EarlyOut early_out) {
  return early_out == EarlyOut::yes && !any_above(neighbour.values, inserted.values);
}

/// Takes a vector down from `place`, whose own content is of no use any more.
void insert_from(float* values, std::uint32_t* ids, std::uint32_t place, Tracked inserted,
                 EarlyOut early_out) {
  for (; place > 0; --place) {
    Tracked neighbour = load(values, ids, place - 1);
    if (stays(inserted, neighbour, early_out)) break;
    split_inline(inserted, neighbour);
    store(neighbour, values, ids, place);
  }
  store(inserted, values, ids, place);
}

/// Inserts the vectors at `place` and above it as if one after the other. The second follows the first two
/// places behind, as long as both go: a split is a chain of steps that each wait for the one before, and two
/// chains hide each other's waits.
void insert_two(float* values, std::uint32_t* ids, std::uint32_t place, EarlyOut early_out) {
  Tracked first = load(values, ids, place);
  Tracked second = load(values, ids, place + 1);
  Tracked between = load(values, ids, place - 1);
  if (stays(first, between, early_out)) return insert_from(values, ids, place + 1, second, early_out);
  split_inline(first, between);
  for (--place; place > 0; --place) {
    Tracked neighbour = load(values, ids, place - 1);
    if (stays(first, neighbour, early_out) || stays(second, between, early_out)) break;
    split_inline(first, neighbour);
    split_inline(second, between);
    store(between, values, ids, place + 2);
    between = neighbour;
  }
  store(between, values, ids, place + 1);
  insert_from(values, ids, place, first, early_out);
  insert_from(values, ids, place + 2, second, early_out);
}

}  // namespace

void split_lanes(Tracked& low, Tracked& high) {
  split_lanes_inline(low, high);
}

void split(Tracked& low, Tracked& high) {
  split_inline(low, high);
}

void intervector_sort(float* values, std::uint32_t* ids, std::uint32_t vectors, EarlyOut early_out) {
  std::uint32_t i = 1;
  for (; i + 1 < vectors; i += 2) insert_two(values, ids, i, early_out);
  if (i < vectors) insert_from(values, ids, i, load(values, ids, i), early_out);
}

}  // namespace cellsweep::cell::paper
