// vmx2spu.h: products of bytes and halfwords, multiply-sums, and sums across elements with saturation.
#ifndef SPU_EMU_INTRINSICS_VMX_MULTIPLY_H
#define SPU_EMU_INTRINSICS_VMX_MULTIPLY_H

#include "spu_emu/intrinsics/multiply.h"
#include "spu_emu/intrinsics/vmx_arithmetic.h"

SPU_EMU_INLINE vec_uint4 vec_mule(vec_ushort8 a, vec_ushort8 b) {
  return spu_mule(a, b);
}

SPU_EMU_INLINE vec_int4 vec_mule(vec_short8 a, vec_short8 b) {
  return spu_mule(a, b);
}

SPU_EMU_INLINE vec_uint4 vec_mulo(vec_ushort8 a, vec_ushort8 b) {
  return spu_mulo(a, b);
}

SPU_EMU_INLINE vec_int4 vec_mulo(vec_short8 a, vec_short8 b) {
  return spu_mulo(a, b);
}

namespace spu_emu::detail {

// Even bytes are the low bytes of the host's halfwords, odd bytes the high ones.
SPU_EMU_INLINE vec_ushort8 even_bytes(vec_uchar16 v) {
  return (vec_ushort8)v & splat<vec_ushort8>(255);
}

SPU_EMU_INLINE vec_ushort8 odd_bytes(vec_uchar16 v) {
  return (vec_ushort8)v >> 8;
}

SPU_EMU_INLINE vec_short8 even_bytes(vec_char16 v) {
  return (vec_short8)((vec_ushort8)v << 8) >> 8;
}

SPU_EMU_INLINE vec_short8 odd_bytes(vec_char16 v) {
  return (vec_short8)v >> 8;
}

}  // namespace spu_emu::detail

SPU_EMU_INLINE vec_ushort8 vec_mule(vec_uchar16 a, vec_uchar16 b) {
  return (vec_ushort8)_mm_mullo_epi16((__m128i)spu_emu::detail::even_bytes(a),
                                      (__m128i)spu_emu::detail::even_bytes(b));
}

SPU_EMU_INLINE vec_short8 vec_mule(vec_char16 a, vec_char16 b) {
  return (vec_short8)_mm_mullo_epi16((__m128i)spu_emu::detail::even_bytes(a),
                                     (__m128i)spu_emu::detail::even_bytes(b));
}

SPU_EMU_INLINE vec_ushort8 vec_mulo(vec_uchar16 a, vec_uchar16 b) {
  return (vec_ushort8)_mm_mullo_epi16((__m128i)spu_emu::detail::odd_bytes(a),
                                      (__m128i)spu_emu::detail::odd_bytes(b));
}

SPU_EMU_INLINE vec_short8 vec_mulo(vec_char16 a, vec_char16 b) {
  return (vec_short8)_mm_mullo_epi16((__m128i)spu_emu::detail::odd_bytes(a),
                                     (__m128i)spu_emu::detail::odd_bytes(b));
}

// The low half of a * b + c, the same for signed and unsigned operands.
template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2> vec_mladd(V a, V b, V c) {
  return (V)_mm_add_epi16(_mm_mullo_epi16((__m128i)a, (__m128i)b), (__m128i)c);
}

SPU_EMU_INLINE vec_short8 vec_mladd(vec_ushort8 a, vec_short8 b, vec_short8 c) {
  return vec_mladd((vec_short8)a, b, c);
}

SPU_EMU_INLINE vec_short8 vec_mladd(vec_short8 a, vec_ushort8 b, vec_ushort8 c) {
  return vec_mladd(a, (vec_short8)b, (vec_short8)c);
}

// The product shifted right by 15, as a halfword, and c, with saturation. The shift keeps 16 bits before the
// sum: -32768 * -32768 gives -32768.
SPU_EMU_INLINE vec_short8 vec_madds(vec_short8 a, vec_short8 b, vec_short8 c) {
  const __m128i high = _mm_slli_epi16(_mm_mulhi_epi16((__m128i)a, (__m128i)b), 1);
  const __m128i low = _mm_srli_epi16(_mm_mullo_epi16((__m128i)a, (__m128i)b), 15);
  return vec_adds((vec_short8)_mm_or_si128(high, low), c);
}

// The same with the product rounded to the nearest, halves up.
SPU_EMU_INLINE vec_short8 vec_mradds(vec_short8 a, vec_short8 b, vec_short8 c) {
  return vec_adds((vec_short8)_mm_mulhrs_epi16((__m128i)a, (__m128i)b), c);
}

// The products within each word and c, added modulo 2^32.
SPU_EMU_INLINE vec_uint4 vec_msum(vec_ushort8 a, vec_ushort8 b, vec_uint4 c) {
  return spu_mule(a, b) + spu_mulo(a, b) + c;
}

SPU_EMU_INLINE vec_int4 vec_msum(vec_short8 a, vec_short8 b, vec_int4 c) {
  return (vec_int4)_mm_add_epi32(_mm_madd_epi16((__m128i)a, (__m128i)b), (__m128i)c);
}

SPU_EMU_INLINE vec_uint4 vec_msum(vec_uchar16 a, vec_uchar16 b, vec_uint4 c) {
  const vec_short8 even_a = (vec_short8)spu_emu::detail::even_bytes(a);
  const vec_short8 odd_a = (vec_short8)spu_emu::detail::odd_bytes(a);
  const vec_int4 odd = vec_msum(odd_a, (vec_short8)spu_emu::detail::odd_bytes(b), (vec_int4)c);
  return (vec_uint4)vec_msum(even_a, (vec_short8)spu_emu::detail::even_bytes(b), odd);
}

SPU_EMU_INLINE vec_int4 vec_msum(vec_char16 a, vec_uchar16 b, vec_int4 c) {
  const vec_int4 odd = vec_msum(spu_emu::detail::odd_bytes(a), (vec_short8)spu_emu::detail::odd_bytes(b), c);
  return vec_msum(spu_emu::detail::even_bytes(a), (vec_short8)spu_emu::detail::even_bytes(b), odd);
}

SPU_EMU_INLINE vec_uint4 vec_msums(vec_ushort8 a, vec_ushort8 b, vec_uint4 c) {
  return vec_adds(vec_adds(spu_mule(a, b), spu_mulo(a, b)), c);
}

// Only the sum with c saturates; that of the two products wraps, which takes four factors of -32768.
SPU_EMU_INLINE vec_int4 vec_msums(vec_short8 a, vec_short8 b, vec_int4 c) {
  return vec_adds((vec_int4)_mm_madd_epi16((__m128i)a, (__m128i)b), c);
}

// The bytes or halfwords within each word, and b.
SPU_EMU_INLINE vec_uint4 vec_sum4s(vec_uchar16 a, vec_uint4 b) {
  return vec_adds(vec_msum(a, spu_emu::detail::splat<vec_uchar16>(1), vec_uint4{}), b);
}

SPU_EMU_INLINE vec_int4 vec_sum4s(vec_char16 a, vec_int4 b) {
  return vec_adds(vec_msum(a, spu_emu::detail::splat<vec_uchar16>(1), vec_int4{}), b);
}

SPU_EMU_INLINE vec_int4 vec_sum4s(vec_short8 a, vec_int4 b) {
  return vec_adds(vec_msum(a, spu_emu::detail::splat<vec_short8>(1), vec_int4{}), b);
}

namespace spu_emu::detail {

SPU_EMU_INLINE int saturate_to_word(long long sum) {
  return static_cast<int>(sum > INT32_MAX ? INT32_MAX : sum < INT32_MIN ? INT32_MIN : sum);
}

}  // namespace spu_emu::detail

// The two words of each half and that half's last word of b; results in elements 1 and 3, zero elsewhere.
SPU_EMU_INLINE vec_int4 vec_sum2s(vec_int4 a, vec_int4 b) {
  const int left = spu_emu::detail::saturate_to_word(static_cast<long long>(a[0]) + a[1] + b[1]);
  const int right = spu_emu::detail::saturate_to_word(static_cast<long long>(a[2]) + a[3] + b[3]);
  return vec_int4{0, left, 0, right};
}

// All words of a and the last one of b; the result in element 3, zero elsewhere.
SPU_EMU_INLINE vec_int4 vec_sums(vec_int4 a, vec_int4 b) {
  const long long sum = static_cast<long long>(a[0]) + a[1] + a[2] + a[3] + b[3];
  return vec_int4{0, 0, 0, spu_emu::detail::saturate_to_word(sum)};
}

#endif
