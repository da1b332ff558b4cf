#include <immintrin.h>

#include "bench/peers/box_pruning.h"

namespace cellsweep::bench {
namespace {

/// A box against which eight at a time are held.
struct Held {
  __m256 max0, min1, max1, min2, max2;
};

// The bits of those of the eight boxes from `j` on that overlap the held one.
unsigned overlapping(const SweepLists& lists, std::size_t j, const Held& held) {
  const auto at = [j](const std::vector<float>& values) { return _mm256_loadu_ps(&values[j]); };
  const __m256 on_0 = _mm256_cmp_ps(at(lists.min[0]), held.max0, _CMP_LE_OQ);
  const __m256 on_1 = _mm256_and_ps(_mm256_cmp_ps(at(lists.min[1]), held.max1, _CMP_LE_OQ),
                                    _mm256_cmp_ps(at(lists.max[1]), held.min1, _CMP_GE_OQ));
  const __m256 on_2 = _mm256_and_ps(_mm256_cmp_ps(at(lists.min[2]), held.max2, _CMP_LE_OQ),
                                    _mm256_cmp_ps(at(lists.max[2]), held.min2, _CMP_GE_OQ));
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_and_ps(on_0, _mm256_and_ps(on_1, on_2))));
}

}  // namespace

void sweep_avx2(const SweepLists& lists, std::vector<Pair>& pairs) {
  for (std::size_t i = 0; i < lists.count; ++i) {
    const float end = lists.max[0][i];
    const Held held = {_mm256_set1_ps(end), _mm256_set1_ps(lists.min[1][i]), _mm256_set1_ps(lists.max[1][i]),
                       _mm256_set1_ps(lists.min[2][i]), _mm256_set1_ps(lists.max[2][i])};
    for (std::size_t j = i + 1; lists.min[0][j] <= end; j += 8) {
      for (unsigned found = overlapping(lists, j, held); found != 0; found &= found - 1) {
        pairs.push_back(make_pair_of(lists.ids[i], lists.ids[j + static_cast<unsigned>(_tzcnt_u32(found))]));
      }
    }
  }
}

}  // namespace cellsweep::bench
