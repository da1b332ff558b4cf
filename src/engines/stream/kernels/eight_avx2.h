/// @file
/// Eight boxes side by side, for kernels with AVX2 or more.
#pragma once

#include <immintrin.h>

#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {
namespace {

/// Four floats of a box, from `skip` on, and of the box four places behind: the lanes of two 4 by 4
/// transpositions.
inline __m256 quarters_of(const std::byte* box, std::size_t step, std::size_t skip) {
  const auto* here = reinterpret_cast<const float*>(box) + skip;
  const auto* behind = reinterpret_cast<const float*>(box + 4 * step) + skip;
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(here)), _mm_loadu_ps(behind), 1);
}

/// Minimum x, y, z, maximum x, y, z of boxes that lie `step` bytes apart.
inline void gather_eight(const Aabb* boxes, std::size_t step, __m256 (&faces)[6]) {
  const auto* box = reinterpret_cast<const std::byte*>(boxes);
  const __m256 a = quarters_of(box, step, 0), b = quarters_of(box + step, step, 0);
  const __m256 c = quarters_of(box + 2 * step, step, 0), d = quarters_of(box + 3 * step, step, 0);
  const __m256 low_ab = _mm256_unpacklo_ps(a, b), high_ab = _mm256_unpackhi_ps(a, b);
  const __m256 low_cd = _mm256_unpacklo_ps(c, d), high_cd = _mm256_unpackhi_ps(c, d);
  faces[0] = _mm256_shuffle_ps(low_ab, low_cd, 0x44);
  faces[1] = _mm256_shuffle_ps(low_ab, low_cd, 0xee);
  faces[2] = _mm256_shuffle_ps(high_ab, high_cd, 0x44);
  faces[3] = _mm256_shuffle_ps(high_ab, high_cd, 0xee);
  // The last two faces stand at the end of the last four floats.
  const __m256 last_ab = _mm256_unpackhi_ps(quarters_of(box, step, 2), quarters_of(box + step, step, 2));
  const __m256 last_cd =
      _mm256_unpackhi_ps(quarters_of(box + 2 * step, step, 2), quarters_of(box + 3 * step, step, 2));
  faces[4] = _mm256_shuffle_ps(last_ab, last_cd, 0x44);
  faces[5] = _mm256_shuffle_ps(last_ab, last_cd, 0xee);
}

/// Cells on one axis; cells and boxes are as GridNumbers says.
inline __m256i cells_on_axis(__m256 coordinates, const GridNumbers& grid, unsigned axis) {
  const __m256 distance = _mm256_sub_ps(coordinates, _mm256_set1_ps(grid.origin[axis]));
  const __m256 cells = _mm256_mul_ps(distance, _mm256_set1_ps(grid.scale[axis]));
  // Where an operand is NaN, the second one is the result.
  const __m256 not_below = _mm256_max_ps(cells, _mm256_setzero_ps());
  return _mm256_cvttps_epi32(_mm256_min_ps(not_below, _mm256_set1_ps(grid.top[axis])));
}

inline void eight_blocks_at_once(const Aabb* boxes, std::size_t step, const GridNumbers& grid,
                                 EightBlocks& blocks) {
  __m256 faces[6];
  gather_eight(boxes, step, faces);
  const int steps[3] = {1, static_cast<int>(grid.row), static_cast<int>(grid.plane)};
  __m256i first = _mm256_setzero_si256();
  __m256i second = first;
  __m256i more = first;
  __m256i flags = _mm256_set1_epi32(kWholeFlags);
  for (unsigned axis = 0; axis < 3; ++axis) {
    const __m256i low = cells_on_axis(faces[axis], grid, axis);
    const __m256i high = cells_on_axis(faces[axis + 3], grid, axis);
    const __m256i more_here = _mm256_sub_epi32(high, low);
    const __m256i axis_step = _mm256_set1_epi32(steps[axis]);
    first = _mm256_add_epi32(first, _mm256_mullo_epi32(low, axis_step));
    second = _mm256_add_epi32(second, _mm256_mullo_epi32(high, axis_step));
    more = _mm256_add_epi32(more, more_here);
    flags = _mm256_xor_si256(flags, _mm256_slli_epi32(more_here, static_cast<int>(axis)));
  }
  const __m256 nobody = _mm256_cmp_ps(faces[0], faces[3], _CMP_NLE_UQ);
  const __m256i whole = _mm256_set1_epi32(static_cast<int>(kWholeFlags << kSlotBits));
  const auto put = [](std::uint32_t* to, __m256i values) {
    _mm256_store_si256(reinterpret_cast<__m256i*>(to), values);
  };
  put(blocks.first, _mm256_or_si256(first, whole));
  put(blocks.second, _mm256_or_si256(second, _mm256_slli_epi32(flags, kSlotBits)));
  put(blocks.more, _mm256_or_si256(more, _mm256_castps_si256(nobody)));
}

inline void eight_rows_at_once(const Aabb* boxes, const GridNumbers& grid, unsigned axis, EightRows& rows) {
  __m256 faces[6];
  gather_eight(boxes, sizeof(Aabb), faces);
  const unsigned y = (axis + 1) % 3, z = (axis + 2) % 3;
  const auto ends = [&](unsigned on, int bits) {
    const __m256i high = cells_on_axis(faces[on + 3], grid, on);
    return _mm256_or_si256(cells_on_axis(faces[on], grid, on), _mm256_slli_epi32(high, bits));
  };
  const __m256i others = _mm256_or_si256(ends(y, 8), _mm256_slli_epi32(ends(z, 8), 16));
  _mm256_store_si256(reinterpret_cast<__m256i*>(rows.on_axis), ends(axis, 16));
  _mm256_store_si256(reinterpret_cast<__m256i*>(rows.on_others), others);
  const __m256 there = _mm256_cmp_ps(faces[0], faces[3], _CMP_LE_OQ);
  rows.there = static_cast<std::uint32_t>(_mm256_movemask_ps(there));
}

}  // namespace
}  // namespace cellsweep::stream
