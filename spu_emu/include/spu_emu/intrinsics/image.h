// Between a vector and its big-endian register image, the 16 bytes an SPU register would hold.
//
// In an image, memory byte k is the SPU's byte k (byte 0 is the most significant byte of element 0). Quadword
// shifts, rotates and spu_shuffle are defined on images, each by the element width of its own argument type.
#ifndef SPU_EMU_INTRINSICS_IMAGE_H
#define SPU_EMU_INTRINSICS_IMAGE_H

#include "spu_emu/intrinsics/traits.h"

namespace spu_emu::detail {

// Reverses the bytes within each lane of Width bytes; its own inverse.
template <int Width>
SPU_EMU_INLINE __m128i reverse_lanes(__m128i v) {
  if constexpr (Width == 1 || is_big_endian)
    return v;
  else if constexpr (Width == 2)
    return _mm_shuffle_epi8(v, _mm_setr_epi8(1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14));
  else if constexpr (Width == 4)
    return _mm_shuffle_epi8(v, _mm_setr_epi8(3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12));
  else
    return _mm_shuffle_epi8(v, _mm_setr_epi8(7, 6, 5, 4, 3, 2, 1, 0, 15, 14, 13, 12, 11, 10, 9, 8));
}

template <typename V>
SPU_EMU_INLINE __m128i to_image(V v) {
  return reverse_lanes<lane_bytes<V>>(bits(v));
}

template <typename V>
SPU_EMU_INLINE V from_image(__m128i image) {
  return from_bits<V>(reverse_lanes<lane_bytes<V>>(image));
}

}  // namespace spu_emu::detail

#endif
