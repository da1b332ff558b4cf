#include "engines/cell/spu/resident/sort_network.h"

#include "engines/cell/spu/resident/lanes.h"

namespace cellsweep::cell {
namespace {

/// Compares vector i with vector i + stride, for all i whose partner that is.
void merge_across(vec_int4* keys, vec_int4* values, unsigned int vectors, unsigned int size,
                  unsigned int stride) {
  for (unsigned int block = 0; block < vectors; block += 2 * stride) {
    const bool descending = (block & size) != 0;
    for (unsigned int i = block; i < block + stride; ++i) {
      const vec_int4 a = keys[i];
      const vec_int4 b = keys[i + stride];
      const vec_int4 value_a = values[i];
      const vec_int4 value_b = values[i + stride];
      const vec_uint4 swap = descending ? spu_cmpgt(b, a) : spu_cmpgt(a, b);
      keys[i] = spu_sel(a, b, swap);
      keys[i + stride] = spu_sel(b, a, swap);
      values[i] = spu_sel(value_a, value_b, swap);
      values[i + stride] = spu_sel(value_b, value_a, swap);
    }
  }
}

struct Lanes {
  vec_int4 key;
  vec_int4 value;
};

/// Compares each lane with its partner; lanes of `takes_larger` keep the larger key.
inline Lanes merge_lanes(const Lanes& four, vec_uchar16 partner, vec_uint4 takes_larger) {
  const vec_int4 other = spu_shuffle(four.key, four.key, partner);
  const vec_int4 other_value = spu_shuffle(four.value, four.value, partner);
  const vec_uint4 swap = spu_sel(spu_cmpgt(four.key, other), spu_cmpgt(other, four.key), takes_larger);
  return {spu_sel(four.key, other, swap), spu_sel(four.value, other_value, swap)};
}

constexpr vec_uchar16 kPartnerOfTwo = word_pattern(1, 0, 3, 2);
constexpr vec_uchar16 kPartnerOfFour = word_pattern(2, 3, 0, 1);
constexpr unsigned int kAll = 0xffffffff;

/// The strides 2 and 1 of a merge whose runs are whole vectors.
void merge_within(vec_int4* keys, vec_int4* values, unsigned int vectors, unsigned int size) {
  const vec_uint4 high_of_four = {0, 0, kAll, kAll};
  const vec_uint4 high_of_two = {0, kAll, 0, kAll};
  for (unsigned int i = 0; i < vectors; ++i) {
    const vec_uint4 descending = spu_splats((i & size) != 0 ? kAll : 0U);
    Lanes four = {keys[i], values[i]};
    four = merge_lanes(four, kPartnerOfFour, spu_xor(high_of_four, descending));
    four = merge_lanes(four, kPartnerOfTwo, spu_xor(high_of_two, descending));
    keys[i] = four.key;
    values[i] = four.value;
  }
}

/// Pairs of lanes: the left one ascending, the right one descending.
void sort_pairs(vec_int4* keys, vec_int4* values, unsigned int vectors) {
  const vec_uint4 larger = {0, kAll, kAll, 0};
  for (unsigned int i = 0; i < vectors; ++i) {
    const Lanes four = merge_lanes({keys[i], values[i]}, kPartnerOfTwo, larger);
    keys[i] = four.key;
    values[i] = four.value;
  }
}

}  // namespace

void sort_network(vec_int4* keys, vec_int4* values, unsigned int vectors) {
  sort_pairs(keys, values, vectors);
  for (unsigned int size = 1; size <= vectors; size *= 2) {
    for (unsigned int stride = size / 2; stride != 0; stride /= 2) {
      merge_across(keys, values, vectors, size, stride);
    }
    merge_within(keys, values, vectors, size);
  }
}

unsigned int remove_duplicates(const vec_int4* keys, vec_int4* values, unsigned int vectors) {
  const vec_int4 last = spu_splats(kLastKey >> 16);
  const vec_uchar16 one_behind = word_pattern(3, 4, 5, 6);
  WordWriter writer((vec_uint4*)values);
  vec_int4 before = last;
  for (unsigned int i = 0; i < vectors; ++i) {
    const vec_int4 half = spu_rlmaska(keys[i], -16);
    const vec_uint4 again = spu_cmpeq(half, spu_shuffle(before, half, one_behind));
    const vec_uint4 drop = spu_or(again, spu_cmpeq(half, last));
    writer.append((vec_uint4)values[i], 15U ^ mask_bits(drop));
    before = half;
  }
  return writer.finish(spu_splats(0U));
}

}  // namespace cellsweep::cell
