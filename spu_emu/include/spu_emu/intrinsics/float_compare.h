// Single-precision compares by the SPU's rule, right for every bit pattern: spu_cmpeq, spu_cmpgt and their
// absolute forms.
//
// Zero is any magnitude below 2^-126, of either sign; all other patterns, exponent 255 included, order by
// sign and magnitude. Default builds compare with SSE, which under the SPU's MXCSR errs only on NaN patterns,
// and fall back to integer keys when one is present; SPU_EMU_PRECISE builds use the keys always and need no
// MXCSR. A source that defines SPU_EMU_NO_NAN_PATTERNS promises that it compares none (or does not care what
// comes of it), and is spared the look for one.
#ifndef SPU_EMU_INTRINSICS_FLOAT_COMPARE_H
#define SPU_EMU_INTRINSICS_FLOAT_COMPARE_H

#include "spu_emu/intrinsics/traits.h"

namespace spu_emu::detail {

SPU_EMU_INLINE vec_float4 magnitude(vec_float4 v) {
  return (vec_float4)_mm_and_si128((__m128i)v, _mm_set1_epi32(0x7fffffff));
}

// Integers in the order of the SPU's floats.
SPU_EMU_INLINE __m128i order_key(vec_float4 v) {
  const __m128i nonzero = _mm_cmpgt_epi32((__m128i)magnitude(v), _mm_set1_epi32(0x007fffff));
  const __m128i b = _mm_and_si128((__m128i)v, nonzero);
  return _mm_xor_si128(b, _mm_srli_epi32(_mm_srai_epi32(b, 31), 1));
}

SPU_EMU_INLINE vec_uint4 key_equal(vec_float4 a, vec_float4 b) {
  return (vec_uint4)_mm_cmpeq_epi32(order_key(a), order_key(b));
}

SPU_EMU_INLINE vec_uint4 key_greater(vec_float4 a, vec_float4 b) {
  return (vec_uint4)_mm_cmpgt_epi32(order_key(a), order_key(b));
}

#ifndef SPU_EMU_PRECISE
SPU_EMU_INLINE bool any_nan([[maybe_unused]] vec_float4 a, [[maybe_unused]] vec_float4 b) {
#ifdef SPU_EMU_NO_NAN_PATTERNS
  return false;
#else
  return __builtin_expect(_mm_movemask_ps(_mm_cmpunord_ps((__m128)a, (__m128)b)), 0) != 0;
#endif
}
#endif

}  // namespace spu_emu::detail

SPU_EMU_INLINE vec_uint4 spu_cmpeq(vec_float4 a, vec_float4 b) {
#ifndef SPU_EMU_PRECISE
  if (!spu_emu::detail::any_nan(a, b)) return (vec_uint4)_mm_cmpeq_ps((__m128)a, (__m128)b);
#endif
  return spu_emu::detail::key_equal(a, b);
}

SPU_EMU_INLINE vec_uint4 spu_cmpgt(vec_float4 a, vec_float4 b) {
#ifndef SPU_EMU_PRECISE
  if (!spu_emu::detail::any_nan(a, b)) return (vec_uint4)_mm_cmpgt_ps((__m128)a, (__m128)b);
#endif
  return spu_emu::detail::key_greater(a, b);
}

SPU_EMU_INLINE vec_uint4 spu_cmpabseq(vec_float4 a, vec_float4 b) {
  return spu_cmpeq(spu_emu::detail::magnitude(a), spu_emu::detail::magnitude(b));
}

SPU_EMU_INLINE vec_uint4 spu_cmpabsgt(vec_float4 a, vec_float4 b) {
  return spu_cmpgt(spu_emu::detail::magnitude(a), spu_emu::detail::magnitude(b));
}

#endif
