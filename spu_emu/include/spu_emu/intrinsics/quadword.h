// Operations on all 128 bits: spu_shuffle, and the quadword shifts and rotates by bits and by bytes.
//
// All of them see the register big-endian, element 0 leftmost, whatever the argument's element width: a
// shuffle pattern byte names the byte that an SPU would take from these arguments. So patterns written as
// vec_uchar16 literals work unmodified on vectors of every type, also where they split elements. What cannot
// be true here: a pattern or argument that came through a plain cast from a type of another element width has
// its bytes in host order. Patterns that move whole words of such a vector still work; for all others cast
// through qword, or write the pattern as a vec_uchar16 literal.
#ifndef SPU_EMU_INTRINSICS_QUADWORD_H
#define SPU_EMU_INTRINSICS_QUADWORD_H

#include "spu_emu/intrinsics/image.h"

namespace spu_emu::detail {

// Pattern bytes 0x80-0xbf give 0x00, 0xc0-0xdf 0xff and 0xe0-0xff 0x80; the low five bits of others pick from
// a:b.
SPU_EMU_INLINE __m128i special_bytes(__m128i pattern) {
  const __m128i at_least_c0 = _mm_cmpeq_epi8(_mm_max_epu8(pattern, _mm_set1_epi8(-64)), pattern);
  const __m128i at_least_e0 = _mm_cmpeq_epi8(_mm_max_epu8(pattern, _mm_set1_epi8(-32)), pattern);
  return _mm_xor_si128(at_least_c0, _mm_and_si128(at_least_e0, _mm_set1_epi8(0x7f)));
}

// a, b and the result in a host order given by `flip`, which is XORed to every byte number; pattern[k] is for
// the result's k-th byte in that same order.
SPU_EMU_INLINE __m128i shuffle_bytes(__m128i a, __m128i b, __m128i pattern, int flip) {
  if constexpr (is_big_endian) flip = 0;
  // pshufb gives zero where bit 7 is set and reads the low four bits elsewhere.
  const __m128i special = _mm_and_si128(pattern, _mm_set1_epi8(-128));
  const __m128i index = _mm_or_si128(
      _mm_xor_si128(_mm_andnot_si128(special, pattern), _mm_set1_epi8(static_cast<char>(flip))), special);
  const __m128i from_a = _mm_shuffle_epi8(a, index);
  const __m128i from_b = _mm_shuffle_epi8(b, index);
  const __m128i in_b = _mm_slli_epi16(pattern, 3);
  return _mm_or_si128(_mm_blendv_epi8(from_a, from_b, in_b), special_bytes(pattern));
}

// Left by 0 to 31 bytes, right by 0 to 31 bytes, left around by any number of bytes; all on images.
SPU_EMU_INLINE __m128i byte_numbers() {
  return _mm_setr_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}

SPU_EMU_INLINE __m128i image_left_bytes(__m128i image, unsigned int count) {
  const __m128i from = _mm_add_epi8(byte_numbers(), _mm_set1_epi8(static_cast<char>(count & 31)));
  return _mm_shuffle_epi8(image, _mm_or_si128(from, _mm_cmpgt_epi8(from, _mm_set1_epi8(15))));
}

SPU_EMU_INLINE __m128i image_right_bytes(__m128i image, unsigned int count) {
  return _mm_shuffle_epi8(image, _mm_sub_epi8(byte_numbers(), _mm_set1_epi8(static_cast<char>(count & 31))));
}

SPU_EMU_INLINE __m128i image_rotate_bytes(__m128i image, unsigned int count) {
  const __m128i from = _mm_add_epi8(byte_numbers(), _mm_set1_epi8(static_cast<char>(count & 15)));
  return _mm_shuffle_epi8(image, _mm_and_si128(from, _mm_set1_epi8(15)));
}

// Bit shifts work on two host-order doublewords in swapped places: lane 0 holds the quadword's low half.
template <typename V>
SPU_EMU_INLINE __m128i to_integer128(V v) {
  if constexpr (lane_bytes<V> == 8 || is_big_endian)
    return _mm_shuffle_epi32((__m128i)v, _MM_SHUFFLE(1, 0, 3, 2));
  else if constexpr (lane_bytes<V> == 4)
    return _mm_shuffle_epi32((__m128i)v, _MM_SHUFFLE(0, 1, 2, 3));
  else
    return _mm_shuffle_epi8(to_image(v), _mm_setr_epi8(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0));
}

template <typename V>
SPU_EMU_INLINE V from_integer128(__m128i n) {
  if constexpr (lane_bytes<V> == 8 || is_big_endian)
    return (V)_mm_shuffle_epi32(n, _MM_SHUFFLE(1, 0, 3, 2));
  else if constexpr (lane_bytes<V> == 4)
    return (V)_mm_shuffle_epi32(n, _MM_SHUFFLE(0, 1, 2, 3));
  else
    return from_image<V>(
        _mm_shuffle_epi8(n, _mm_setr_epi8(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0)));
}

// By 0 to 7 bits. The bits that cross between the halves come from the other doubleword.
SPU_EMU_INLINE __m128i integer_left_bits(__m128i n, __m128i crossing, unsigned int count) {
  const __m128i left = _mm_cvtsi32_si128(static_cast<int>(count & 7));
  const __m128i right = _mm_cvtsi32_si128(static_cast<int>(64 - (count & 7)));
  return _mm_or_si128(_mm_sll_epi64(n, left), _mm_srl_epi64(crossing, right));
}

SPU_EMU_INLINE __m128i integer_right_bits(__m128i n, unsigned int count) {
  const __m128i right = _mm_cvtsi32_si128(static_cast<int>(count & 7));
  const __m128i left = _mm_cvtsi32_si128(static_cast<int>(64 - (count & 7)));
  return _mm_or_si128(_mm_srl_epi64(n, right), _mm_sll_epi64(_mm_srli_si128(n, 8), left));
}

// What the SPU's "from bit shift count" forms do with a count in bits.
SPU_EMU_INLINE unsigned int bytes_of_bits(int count) {
  return static_cast<unsigned int>(count) >> 3;
}

SPU_EMU_INLINE unsigned int negated(int count) {
  return 0U - static_cast<unsigned int>(count);
}

SPU_EMU_INLINE unsigned int negated_bytes_of_bits(int count) {
  return 0U - bytes_of_bits(count);
}

#if defined(__GNUC__) && !defined(__clang__)
// True when the compiler knows the pattern, and no byte of it stands for a constant.
SPU_EMU_INLINE bool is_known_move(vec_uchar16 pattern) {
  const auto halves = (vec_ullong2)pattern;
  return __builtin_constant_p(halves[0]) && __builtin_constant_p(halves[1]) &&
         ((halves[0] | halves[1]) & 0x8080808080808080U) == 0;
}

// The same shuffle in host order for the compiler, which has instructions for many patterns.
template <int Width>
SPU_EMU_INLINE __m128i known_move(__m128i a, __m128i b, vec_uchar16 pattern) {
  constexpr unsigned char flip = Width - 1;
  const vec_uchar16 numbers = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  const vec_uchar16 in_host_order = __builtin_shuffle(pattern, numbers ^ flip) ^ flip;
  return (__m128i)__builtin_shuffle((vec_uchar16)a, (vec_uchar16)b, in_host_order);
}
#endif

}  // namespace spu_emu::detail

template <typename V>
SPU_EMU_INLINE V spu_shuffle(V a, V b, vec_uchar16 pattern) {
  namespace d = spu_emu::detail;
  constexpr int width = d::lane_bytes<V>;
#if defined(__GNUC__) && !defined(__clang__)
  if (d::is_known_move(pattern)) return (V)d::known_move<width>((__m128i)a, (__m128i)b, pattern);
#endif
  // The pattern's k-th byte must sit where the result's k-th byte sits: the same lane reversal as the data.
  return (V)d::shuffle_bytes((__m128i)a, (__m128i)b, d::reverse_lanes<width>((__m128i)pattern), width - 1);
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_slqw(V a, unsigned int count) {
  namespace d = spu_emu::detail;
  const __m128i n = d::to_integer128(a);
  return d::from_integer128<V>(d::integer_left_bits(n, _mm_slli_si128(n, 8), count));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_slqwbyte(V a, unsigned int count) {
  return spu_emu::detail::from_image<V>(
      spu_emu::detail::image_left_bytes(spu_emu::detail::to_image(a), count));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_slqwbytebc(V a, unsigned int count) {
  return spu_slqwbyte(a, count >> 3);
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_srqw(V a, unsigned int count) {
  namespace d = spu_emu::detail;
  return d::from_integer128<V>(d::integer_right_bits(d::to_integer128(a), count));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_srqwbyte(V a, unsigned int count) {
  return spu_emu::detail::from_image<V>(
      spu_emu::detail::image_right_bytes(spu_emu::detail::to_image(a), count));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_srqwbytebc(V a, unsigned int count) {
  return spu_srqwbyte(a, count >> 3);
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_rlqw(V a, int count) {
  namespace d = spu_emu::detail;
  const __m128i n = d::to_integer128(a);
  const __m128i crossing = _mm_shuffle_epi32(n, _MM_SHUFFLE(1, 0, 3, 2));
  return d::from_integer128<V>(d::integer_left_bits(n, crossing, static_cast<unsigned int>(count)));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_rlqwbyte(V a, int count) {
  namespace d = spu_emu::detail;
  return d::from_image<V>(d::image_rotate_bytes(d::to_image(a), static_cast<unsigned int>(count)));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_rlqwbytebc(V a, int count) {
  namespace d = spu_emu::detail;
  return d::from_image<V>(d::image_rotate_bytes(d::to_image(a), d::bytes_of_bits(count)));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_rlmaskqw(V a, int count) {
  return spu_srqw(a, spu_emu::detail::negated(count));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_rlmaskqwbyte(V a, int count) {
  return spu_srqwbyte(a, spu_emu::detail::negated(count));
}

// Right by the negated number of whole bytes in the count, rounded down: -1 to -8 shift by one byte.
template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_rlmaskqwbytebc(V a, int count) {
  return spu_srqwbyte(a, spu_emu::detail::negated_bytes_of_bits(count));
}

#endif
