// The part of SSE that the intrinsics are written in, for processors without it: the compiler's own vectors.
//
// Names and meanings are those of <smmintrin.h>, where lanes and bytes are numbered as they lie in memory.
// Arithmetic on floating point is in generic_floats.h.
#ifndef SPU_EMU_INTRINSICS_GENERIC_VECTORS_H
#define SPU_EMU_INTRINSICS_GENERIC_VECTORS_H

#include <cstdint>

using __m128i = long long __attribute__((vector_size(16), may_alias));
using __m128 = float __attribute__((vector_size(16), may_alias));
using __m128d = double __attribute__((vector_size(16), may_alias));

namespace spu_emu::detail {

using Bytes = unsigned char __attribute__((vector_size(16)));
using SignedBytes = signed char __attribute__((vector_size(16)));
using Halves = unsigned short __attribute__((vector_size(16)));
using SignedHalves = short __attribute__((vector_size(16)));
using Words = unsigned int __attribute__((vector_size(16)));
using SignedWords = int __attribute__((vector_size(16)));
using Doublewords = unsigned long long __attribute__((vector_size(16)));

// function(lane) for every lane of a V.
template <typename V, typename Function>
inline V make_lanes(Function function) {
  V result{};
  for (unsigned lane = 0; lane < sizeof(V) / sizeof(result[0]); ++lane) result[lane] = function(lane);
  return result;
}

}  // namespace spu_emu::detail

// ---- constants and single lanes

inline __m128i _mm_setzero_si128() {
  return __m128i{};
}
inline __m128 _mm_setzero_ps() {
  return __m128{};
}
inline __m128i _mm_set1_epi8(char x) {
  return (__m128i)(spu_emu::detail::Bytes{} + static_cast<unsigned char>(x));
}
inline __m128i _mm_set1_epi16(short x) {
  return (__m128i)(spu_emu::detail::SignedHalves{} + x);
}
inline __m128i _mm_set1_epi32(int x) {
  return (__m128i)spu_emu::detail::SignedWords{x, x, x, x};
}
inline __m128i _mm_set1_epi64x(long long x) {
  return __m128i{x, x};
}
inline __m128i _mm_set_epi64x(long long high, long long low) {
  return __m128i{low, high};
}
inline long long _mm_cvtsi128_si64(__m128i v) {
  return v[0];
}
inline __m128 _mm_set1_ps(float x) {
  return __m128{x, x, x, x};
}
inline __m128d _mm_set1_pd(double x) {
  return __m128d{x, x};
}
inline __m128d _mm_setr_pd(double a, double b) {
  return __m128d{a, b};
}
inline __m128i _mm_setr_epi32(int a, int b, int c, int d) {
  return (__m128i)spu_emu::detail::SignedWords{a, b, c, d};
}
template <typename... Shorts>
inline __m128i _mm_setr_epi16(Shorts... x) {
  return (__m128i)spu_emu::detail::SignedHalves{static_cast<short>(x)...};
}
template <typename... Chars>
inline __m128i _mm_setr_epi8(Chars... x) {
  return (__m128i)spu_emu::detail::SignedBytes{static_cast<signed char>(x)...};
}
inline __m128i _mm_cvtsi32_si128(int x) {
  return (__m128i)spu_emu::detail::SignedWords{x, 0, 0, 0};
}

// ---- the same bits as another type

inline __m128 _mm_castsi128_ps(__m128i v) {
  return (__m128)v;
}
inline __m128d _mm_castsi128_pd(__m128i v) {
  return (__m128d)v;
}
inline __m128i _mm_castps_si128(__m128 v) {
  return (__m128i)v;
}
inline __m128d _mm_castps_pd(__m128 v) {
  return (__m128d)v;
}
inline __m128i _mm_castpd_si128(__m128d v) {
  return (__m128i)v;
}
inline __m128 _mm_castpd_ps(__m128d v) {
  return (__m128)v;
}

// ---- logic

inline __m128i _mm_and_si128(__m128i a, __m128i b) {
  return a & b;
}
inline __m128i _mm_or_si128(__m128i a, __m128i b) {
  return a | b;
}
inline __m128i _mm_xor_si128(__m128i a, __m128i b) {
  return a ^ b;
}
inline __m128i _mm_andnot_si128(__m128i a, __m128i b) {
  return ~a & b;
}
inline __m128 _mm_and_ps(__m128 a, __m128 b) {
  return (__m128)((__m128i)a & (__m128i)b);
}
inline __m128d _mm_xor_pd(__m128d a, __m128d b) {
  return (__m128d)((__m128i)a ^ (__m128i)b);
}
inline __m128d _mm_andnot_pd(__m128d a, __m128d b) {
  return (__m128d)(~(__m128i)a & (__m128i)b);
}

// ---- integer arithmetic

inline __m128i _mm_add_epi8(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::Bytes)a + (spu_emu::detail::Bytes)b);
}
inline __m128i _mm_sub_epi8(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::Bytes)a - (spu_emu::detail::Bytes)b);
}
inline __m128i _mm_add_epi32(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::Words)a + (spu_emu::detail::Words)b);
}
inline __m128i _mm_sub_epi32(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::Words)a - (spu_emu::detail::Words)b);
}
inline __m128i _mm_mullo_epi32(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::Words)a * (spu_emu::detail::Words)b);
}
inline __m128i _mm_mullo_epi16(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::Halves)a * (spu_emu::detail::Halves)b);
}
inline __m128i _mm_subs_epu8(__m128i a, __m128i b) {
  const auto x = (spu_emu::detail::Bytes)a;
  const auto y = (spu_emu::detail::Bytes)b;
  return (__m128i)((x - y) & (spu_emu::detail::Bytes)(x > y));
}
inline __m128i _mm_max_epu8(__m128i a, __m128i b) {
  const auto x = (spu_emu::detail::Bytes)a;
  const auto y = (spu_emu::detail::Bytes)b;
  const auto first = (spu_emu::detail::Bytes)(x > y);
  return (__m128i)((x & first) | (y & ~first));
}
inline __m128i _mm_max_epi32(__m128i a, __m128i b) {
  const auto first = (__m128i)((spu_emu::detail::SignedWords)a > (spu_emu::detail::SignedWords)b);
  return (a & first) | (b & ~first);
}
inline __m128i _mm_max_epu32(__m128i a, __m128i b) {
  const auto first = (__m128i)((spu_emu::detail::Words)a > (spu_emu::detail::Words)b);
  return (a & first) | (b & ~first);
}
inline __m128i _mm_avg_epu8(__m128i a, __m128i b) {
  const auto x = (spu_emu::detail::Bytes)a;
  const auto y = (spu_emu::detail::Bytes)b;
  return (__m128i)((x | y) - ((x ^ y) >> 1));
}
// Unsigned bytes of a times signed ones of b, neighbours added; the sums of the uses here never saturate.
inline __m128i _mm_maddubs_epi16(__m128i a, __m128i b) {
  const auto x = (spu_emu::detail::Bytes)a;
  const auto y = (spu_emu::detail::SignedBytes)b;
  return (__m128i)spu_emu::detail::make_lanes<spu_emu::detail::SignedHalves>([&](unsigned lane) {
    return static_cast<short>(x[2 * lane] * y[2 * lane] + x[2 * lane + 1] * y[2 * lane + 1]);
  });
}
inline __m128i _mm_madd_epi16(__m128i a, __m128i b) {
  const auto x = (spu_emu::detail::SignedHalves)a;
  const auto y = (spu_emu::detail::SignedHalves)b;
  return (__m128i)spu_emu::detail::make_lanes<spu_emu::detail::SignedWords>(
      [&](unsigned lane) { return x[2 * lane] * y[2 * lane] + x[2 * lane + 1] * y[2 * lane + 1]; });
}
inline __m128i _mm_hadd_epi16(__m128i a, __m128i b) {
  return (__m128i)spu_emu::detail::make_lanes<spu_emu::detail::Halves>([&](unsigned lane) {
    const auto from = (spu_emu::detail::Halves)(lane < 4 ? a : b);
    return static_cast<unsigned short>(from[2 * (lane & 3)] + from[2 * (lane & 3) + 1]);
  });
}

// ---- compares

inline __m128i _mm_cmpeq_epi8(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::Bytes)a == (spu_emu::detail::Bytes)b);
}
inline __m128i _mm_cmpeq_epi16(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::Halves)a == (spu_emu::detail::Halves)b);
}
inline __m128i _mm_cmpeq_epi32(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::Words)a == (spu_emu::detail::Words)b);
}
inline __m128i _mm_cmpgt_epi8(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::SignedBytes)a > (spu_emu::detail::SignedBytes)b);
}
inline __m128i _mm_cmpgt_epi16(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::SignedHalves)a > (spu_emu::detail::SignedHalves)b);
}
inline __m128i _mm_cmpgt_epi32(__m128i a, __m128i b) {
  return (__m128i)((spu_emu::detail::SignedWords)a > (spu_emu::detail::SignedWords)b);
}
inline __m128 _mm_cmpunord_ps(__m128 a, __m128 b) {
  return (__m128) ~((a == a) & (b == b));
}
inline __m128d _mm_cmpunord_pd(__m128d a, __m128d b) {
  return (__m128d) ~((a == a) & (b == b));
}
inline __m128d _mm_cmpeq_pd(__m128d a, __m128d b) {
  return (__m128d)(a == b);
}
inline __m128d _mm_cmpgt_pd(__m128d a, __m128d b) {
  return (__m128d)(a > b);
}

// ---- shifts

inline __m128i _mm_slli_epi16(__m128i v, int count) {
  return (__m128i)((spu_emu::detail::Halves)v << count);
}
inline __m128i _mm_srli_epi16(__m128i v, int count) {
  return (__m128i)((spu_emu::detail::Halves)v >> count);
}
inline __m128i _mm_srai_epi16(__m128i v, int count) {
  return (__m128i)((spu_emu::detail::SignedHalves)v >> count);
}
inline __m128i _mm_slli_epi32(__m128i v, int count) {
  return (__m128i)((spu_emu::detail::Words)v << count);
}
inline __m128i _mm_srli_epi32(__m128i v, int count) {
  return (__m128i)((spu_emu::detail::Words)v >> count);
}
inline __m128i _mm_srai_epi32(__m128i v, int count) {
  return (__m128i)((spu_emu::detail::SignedWords)v >> count);
}

// By the number in the first word of `count`; from the width of a lane on nothing, or the sign, is left.
inline __m128i _mm_sll_epi16(__m128i v, __m128i count) {
  const unsigned n = ((spu_emu::detail::Words)count)[0];
  return n < 16 ? _mm_slli_epi16(v, static_cast<int>(n)) : __m128i{};
}
inline __m128i _mm_srl_epi16(__m128i v, __m128i count) {
  const unsigned n = ((spu_emu::detail::Words)count)[0];
  return n < 16 ? _mm_srli_epi16(v, static_cast<int>(n)) : __m128i{};
}
inline __m128i _mm_sra_epi16(__m128i v, __m128i count) {
  const unsigned n = ((spu_emu::detail::Words)count)[0];
  return _mm_srai_epi16(v, static_cast<int>(n < 16 ? n : 15));
}
inline __m128i _mm_sll_epi32(__m128i v, __m128i count) {
  const unsigned n = ((spu_emu::detail::Words)count)[0];
  return n < 32 ? _mm_slli_epi32(v, static_cast<int>(n)) : __m128i{};
}
inline __m128i _mm_srl_epi32(__m128i v, __m128i count) {
  const unsigned n = ((spu_emu::detail::Words)count)[0];
  return n < 32 ? _mm_srli_epi32(v, static_cast<int>(n)) : __m128i{};
}
inline __m128i _mm_sra_epi32(__m128i v, __m128i count) {
  const unsigned n = ((spu_emu::detail::Words)count)[0];
  return _mm_srai_epi32(v, static_cast<int>(n < 32 ? n : 31));
}

inline __m128i _mm_sll_epi64(__m128i v, __m128i count) {
  const unsigned n = ((spu_emu::detail::Words)count)[0];
  return n < 64 ? (__m128i)((spu_emu::detail::Doublewords)v << n) : __m128i{};
}
inline __m128i _mm_srl_epi64(__m128i v, __m128i count) {
  const unsigned n = ((spu_emu::detail::Words)count)[0];
  return n < 64 ? (__m128i)((spu_emu::detail::Doublewords)v >> n) : __m128i{};
}
// Of whole bytes; only the eight that the intrinsics need.
inline __m128i _mm_slli_si128(__m128i v, [[maybe_unused]] int bytes) {
  return __m128i{0, v[0]};
}
inline __m128i _mm_srli_si128(__m128i v, [[maybe_unused]] int bytes) {
  return __m128i{v[1], 0};
}

#endif
