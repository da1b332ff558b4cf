// vmx2spu.h: between element widths: vec_pack and its saturating forms, vec_unpackh/l, vec_mergeh/l, pixels.
//
// A pixel is 1/5/5/5 bits. Pixels and boolean halfwords are the same vector type on an SPU; vec_unpackh and
// vec_unpackl take them as booleans unless SUPPORT_UNPACK_PIXEL is defined.
#ifndef SPU_EMU_INTRINSICS_VMX_PACK_H
#define SPU_EMU_INTRINSICS_VMX_PACK_H

#include "spu_emu/intrinsics/logical.h"
#include "spu_emu/intrinsics/vmx_types.h"

SPU_EMU_INLINE vec_uchar16 vec_packs(vec_ushort8 a, vec_ushort8 b) {
  const __m128i limit = _mm_set1_epi16(255);
  return (vec_uchar16)_mm_packus_epi16(_mm_min_epu16((__m128i)a, limit), _mm_min_epu16((__m128i)b, limit));
}

SPU_EMU_INLINE vec_char16 vec_packs(vec_short8 a, vec_short8 b) {
  return (vec_char16)_mm_packs_epi16((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_ushort8 vec_packs(vec_uint4 a, vec_uint4 b) {
  const __m128i limit = _mm_set1_epi32(65535);
  return (vec_ushort8)_mm_packus_epi32(_mm_min_epu32((__m128i)a, limit), _mm_min_epu32((__m128i)b, limit));
}

SPU_EMU_INLINE vec_short8 vec_packs(vec_int4 a, vec_int4 b) {
  return (vec_short8)_mm_packs_epi32((__m128i)a, (__m128i)b);
}

// To unsigned: negative numbers become zero.
SPU_EMU_INLINE vec_uchar16 vec_packsu(vec_ushort8 a, vec_ushort8 b) {
  return vec_packs(a, b);
}

SPU_EMU_INLINE vec_uchar16 vec_packsu(vec_short8 a, vec_short8 b) {
  return (vec_uchar16)_mm_packus_epi16((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_ushort8 vec_packsu(vec_uint4 a, vec_uint4 b) {
  return vec_packs(a, b);
}

SPU_EMU_INLINE vec_ushort8 vec_packsu(vec_int4 a, vec_int4 b) {
  return (vec_ushort8)_mm_packus_epi32((__m128i)a, (__m128i)b);
}

// The right half of every element.
SPU_EMU_INLINE vec_uchar16 vec_pack(vec_ushort8 a, vec_ushort8 b) {
  const vec_ushort8 right = spu_emu::detail::splat<vec_ushort8>(255);
  return (vec_uchar16)_mm_packus_epi16((__m128i)(a & right), (__m128i)(b & right));
}

SPU_EMU_INLINE vec_char16 vec_pack(vec_short8 a, vec_short8 b) {
  return (vec_char16)vec_pack((vec_ushort8)a, (vec_ushort8)b);
}

SPU_EMU_INLINE vec_ushort8 vec_pack(vec_uint4 a, vec_uint4 b) {
  const vec_uint4 right = spu_emu::detail::splat<vec_uint4>(65535);
  return (vec_ushort8)_mm_packus_epi32((__m128i)(a & right), (__m128i)(b & right));
}

SPU_EMU_INLINE vec_short8 vec_pack(vec_int4 a, vec_int4 b) {
  return (vec_short8)vec_pack((vec_uint4)a, (vec_uint4)b);
}

namespace spu_emu::detail {

// The lowest bit of the leftmost byte and five high bits of each other byte.
SPU_EMU_INLINE vec_uint4 word_to_pixel(vec_uint4 w) {
  const vec_uint4 five = splat<vec_uint4>(31);
  const vec_uint4 one = splat<vec_uint4>(1);
  return (((w >> 24) & one) << 15) | (((w >> 19) & five) << 10) | (((w >> 11) & five) << 5) |
         ((w >> 3) & five);
}

// The first bit fills a byte, the five-bit fields are right-aligned in theirs.
SPU_EMU_INLINE vec_uint4 pixel_to_word(vec_int4 p) {
  const vec_uint4 five = splat<vec_uint4>(31);
  const vec_uint4 bits_of = (vec_uint4)p;
  const vec_uint4 first = (vec_uint4)((vec_int4)(bits_of << 16) >> 31) & splat<vec_uint4>(0xff000000U);
  return first | (((bits_of >> 10) & five) << 16) | (((bits_of >> 5) & five) << 8) | (bits_of & five);
}

// The left and right half of a vector, sign-extended.
SPU_EMU_INLINE vec_int4 left_words(vec_ushort8 v) {
  return (vec_int4)_mm_cvtepi16_epi32((__m128i)v);
}

SPU_EMU_INLINE vec_int4 right_words(vec_ushort8 v) {
  return (vec_int4)_mm_cvtepi16_epi32(_mm_srli_si128((__m128i)v, 8));
}

}  // namespace spu_emu::detail

SPU_EMU_INLINE vec_pixel8 vec_packpx(vec_uint4 a, vec_uint4 b) {
  return vec_pack(spu_emu::detail::word_to_pixel(a), spu_emu::detail::word_to_pixel(b));
}

SPU_EMU_INLINE vec_short8 vec_unpackh(vec_char16 a) {
  return (vec_short8)_mm_cvtepi8_epi16((__m128i)a);
}

SPU_EMU_INLINE vec_short8 vec_unpackl(vec_char16 a) {
  return (vec_short8)_mm_cvtepi8_epi16(_mm_srli_si128((__m128i)a, 8));
}

SPU_EMU_INLINE vec_bshort8 vec_unpackh(vec_bchar16 a) {
  return (vec_bshort8)vec_unpackh((vec_char16)a);
}

SPU_EMU_INLINE vec_bshort8 vec_unpackl(vec_bchar16 a) {
  return (vec_bshort8)vec_unpackl((vec_char16)a);
}

SPU_EMU_INLINE vec_int4 vec_unpackh(vec_short8 a) {
  return spu_emu::detail::left_words((vec_ushort8)a);
}

SPU_EMU_INLINE vec_int4 vec_unpackl(vec_short8 a) {
  return spu_emu::detail::right_words((vec_ushort8)a);
}

SPU_EMU_INLINE vec_uint4 vec_unpackh(vec_pixel8 a) {
#ifdef SUPPORT_UNPACK_PIXEL
  return spu_emu::detail::pixel_to_word(spu_emu::detail::left_words(a));
#else
  return (vec_uint4)spu_emu::detail::left_words(a);
#endif
}

SPU_EMU_INLINE vec_uint4 vec_unpackl(vec_pixel8 a) {
#ifdef SUPPORT_UNPACK_PIXEL
  return spu_emu::detail::pixel_to_word(spu_emu::detail::right_words(a));
#else
  return (vec_uint4)spu_emu::detail::right_words(a);
#endif
}

// Elements of the left halves, or of the right halves, alternately from a and b.
template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE V vec_mergeh(V a, V b) {
  constexpr int width = spu_emu::detail::lane_bytes<V>;
  return (V)(width == 1   ? _mm_unpacklo_epi8((__m128i)a, (__m128i)b)
             : width == 2 ? _mm_unpacklo_epi16((__m128i)a, (__m128i)b)
                          : _mm_unpacklo_epi32((__m128i)a, (__m128i)b));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE V vec_mergel(V a, V b) {
  constexpr int width = spu_emu::detail::lane_bytes<V>;
  return (V)(width == 1   ? _mm_unpackhi_epi8((__m128i)a, (__m128i)b)
             : width == 2 ? _mm_unpackhi_epi16((__m128i)a, (__m128i)b)
                          : _mm_unpackhi_epi32((__m128i)a, (__m128i)b));
}

#endif
