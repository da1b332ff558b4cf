#include "engines/cell/spu/brute/overlap_row.h"

namespace cellsweep::cell {
namespace {

constexpr unsigned int kArrays = 6;

float value_of(const vec_float4* boxes, std::uint32_t vectors, unsigned int array, std::uint32_t body) {
  return reinterpret_cast<const float*>(boxes + array * vectors)[body];
}

/// Four bits, the first body's on the left: which of four boxes are apart on no axis.
inline std::uint32_t overlaps_of_four(const vec_float4* boxes, std::uint32_t vectors, const vec_float4* own) {
  vec_uint4 apart = spu_splats(0U);
  for (unsigned int axis = 0; axis < 3; ++axis) {
    const vec_float4 min = boxes[axis * vectors];
    const vec_float4 max = boxes[(axis + 3) * vectors];
    apart = spu_or(apart, spu_or(spu_cmpgt(own[axis], max), spu_cmpgt(min, own[axis + 3])));
  }
  return spu_extract(spu_gather(spu_nor(apart, apart)), 0);
}

}  // namespace

void overlap_row(const vec_float4* boxes, std::uint32_t bodies, std::uint32_t body, std::uint32_t* row) {
  const std::uint32_t vectors = bodies / 4;
  vec_float4 own[kArrays];
  for (unsigned int array = 0; array < kArrays; ++array) {
    own[array] = spu_splats(value_of(boxes, vectors, array, body));
  }
  for (std::uint32_t word = 0; word < bodies / 32; ++word) {
    std::uint32_t bits = 0;
    for (std::uint32_t four = word * 8; four < word * 8 + 8; ++four) {
      bits = (bits << 4) | overlaps_of_four(boxes + four, vectors, own);
    }
    row[word] = bits;
  }
}

}  // namespace cellsweep::cell
