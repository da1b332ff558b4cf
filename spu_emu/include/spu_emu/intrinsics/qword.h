// qword: one SPU register with no element type, and the exact way to reinterpret one vector type as another.
//
// A qword holds the register as four words in the host's byte order. Casting a vector to qword and a qword to
// a vector reorders bytes as the SPU would see them, so `(vec_ushort8)(qword)v` is true to the SPU for every
// pair of types, where `(vec_ushort8)v` is not when element widths differ. Casts from and to four-byte types
// cost nothing. In memory a qword is four host words, so arrays of words may be read as qwords.
#ifndef SPU_EMU_INTRINSICS_QWORD_H
#define SPU_EMU_INTRINSICS_QWORD_H

#include "spu_emu/intrinsics/image.h"

namespace spu_emu::detail {

// Swaps between lanes of Width bytes and lanes of words, both in host order; its own inverse.
template <int Width>
SPU_EMU_INLINE __m128i lanes_as_words(__m128i v) {
  if constexpr (is_big_endian)
    return v;
  else if constexpr (Width == 1)
    return reverse_lanes<4>(v);
  else if constexpr (Width == 2)
    return _mm_shuffle_epi8(v, _mm_setr_epi8(2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13));
  else if constexpr (Width == 4)
    return v;
  else
    return _mm_shuffle_epi32(v, _MM_SHUFFLE(2, 3, 0, 1));
}

}  // namespace spu_emu::detail

class qword {
 public:
  qword() = default;
  template <typename V, int Width = spu_emu::detail::lane_bytes<V>>
  SPU_EMU_INLINE explicit qword(V v)
      : words_((vec_uint4)spu_emu::detail::lanes_as_words<Width>(spu_emu::detail::bits(v))) {}
  template <typename V, int Width = spu_emu::detail::lane_bytes<V>>
  SPU_EMU_INLINE explicit operator V() const {
    return spu_emu::detail::from_bits<V>(spu_emu::detail::lanes_as_words<Width>((__m128i)words_));
  }

 private:
  vec_uint4 words_;
};

static_assert(sizeof(qword) == 16 && std::is_trivially_copyable_v<qword>, "a qword is one register");

#endif
