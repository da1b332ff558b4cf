#include "engines/cell/spu/paper/intravector_sort.h"

namespace cellsweep::cell::paper {
namespace {

/// The constants of one compare-and-rearrange step.
struct Step {
  vec_uchar16 partner;  ///< the pattern that brings each lane the element it is compared with
  vec_uchar16 add_index;
  vec_uchar16 basis_index;
  vec_uchar16 forced;  ///< C8: the lanes that take their partner's place when the two are equal
};

const Step kReverse = {{12, 13, 14, 15, 8, 9, 10, 11, 4, 5, 6, 7, 0, 1, 2, 3},
                       {12, 12, 12, 12, 4, 4, 4, 4, 4, 4, 4, 4, 12, 12, 12, 12},
                       {0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 0, 1, 2, 3},
                       {255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0}};

const Step kInOut = {{4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11},
                     {4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
                     {0, 1, 2, 3, 0, 1, 2, 3, 8, 9, 10, 11, 8, 9, 10, 11},
                     {255, 255, 255, 255, 0, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 0}};

const Step kMiddle = {{0, 1, 2, 3, 8, 9, 10, 11, 4, 5, 6, 7, 12, 13, 14, 15},
                      {0, 0, 0, 0, 4, 4, 4, 4, 4, 4, 4, 4, 0, 0, 0, 0},
                      {0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 12, 13, 14, 15},
                      {0, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0}};

inline void compare_and_rearrange(Tracked& tracked, const Step& step) {
  const vec_float4 partner = vec_perm(tracked.values, tracked.values, step.partner);
  const auto greater = (vec_uchar16)vec_cmpgt(tracked.values, partner);
  const auto equal = (vec_uchar16)vec_cmpeq(tracked.values, partner);
  const vec_uchar16 mask = vec_or(greater, vec_and(equal, step.forced));
  const vec_uchar16 pattern = vec_add(vec_and(mask, step.add_index), step.basis_index);
  tracked.values = vec_perm(tracked.values, tracked.values, pattern);
  tracked.ids = vec_perm(tracked.ids, tracked.ids, pattern);
}

inline void sort_elements_inline(Tracked& tracked) {
  compare_and_rearrange(tracked, kReverse);
  compare_and_rearrange(tracked, kInOut);
  compare_and_rearrange(tracked, kMiddle);
}

}  // namespace

void sort_elements(Tracked& tracked) {
  sort_elements_inline(tracked);
}

void intravector_sort(float* values, std::uint32_t* ids, std::uint32_t vectors) {
  for (std::uint32_t i = 0; i < vectors; ++i) {
    Tracked tracked = load(values, ids, i);
    sort_elements_inline(tracked);
    store(tracked, values, ids, i);
  }
}

}  // namespace cellsweep::cell::paper
