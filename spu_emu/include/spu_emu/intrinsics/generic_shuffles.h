// The part of SSE's moves between lanes that the intrinsics are written in, for processors without it.
#ifndef SPU_EMU_INTRINSICS_GENERIC_SHUFFLES_H
#define SPU_EMU_INTRINSICS_GENERIC_SHUFFLES_H

#include "spu_emu/intrinsics/generic_vectors.h"

#define _MM_SHUFFLE(d, c, b, a) (((d) << 6) | ((c) << 4) | ((b) << 2) | (a))

// A byte of `order` with bit 7 set gives zero.
inline __m128i _mm_shuffle_epi8(__m128i v, __m128i order) {
  const auto from = (spu_emu::detail::Bytes)order;
  const auto kept = (spu_emu::detail::Bytes)((spu_emu::detail::SignedBytes)order >= 0);
  return (__m128i)(__builtin_shuffle((spu_emu::detail::Bytes)v, from & 15) & kept);
}

namespace spu_emu::detail {

template <typename V>
inline V choose_words(V first, V second, int order) {
  const Words a = (Words)first;
  const Words b = (Words)second;
  return (V)Words{a[order & 3], a[(order >> 2) & 3], b[(order >> 4) & 3], b[(order >> 6) & 3]};
}

}  // namespace spu_emu::detail

inline __m128i _mm_shuffle_epi32(__m128i v, int order) {
  return spu_emu::detail::choose_words(v, v, order);
}
inline __m128 _mm_shuffle_ps(__m128 a, __m128 b, int order) {
  return spu_emu::detail::choose_words(a, b, order);
}
inline __m128 _mm_movehl_ps(__m128 a, __m128 b) {
  return __m128{b[2], b[3], a[2], a[3]};
}
inline __m128 _mm_movelh_ps(__m128 a, __m128 b) {
  return __m128{a[0], a[1], b[0], b[1]};
}
inline __m128 _mm_unpacklo_ps(__m128 a, __m128 b) {
  return __m128{a[0], b[0], a[1], b[1]};
}
inline __m128i _mm_unpacklo_epi16(__m128i a, __m128i b) {
  const auto x = (spu_emu::detail::Halves)a;
  const auto y = (spu_emu::detail::Halves)b;
  return (__m128i)spu_emu::detail::Halves{x[0], y[0], x[1], y[1], x[2], y[2], x[3], y[3]};
}
inline __m128i _mm_unpacklo_epi32(__m128i a, __m128i b) {
  const auto x = (spu_emu::detail::Words)a;
  const auto y = (spu_emu::detail::Words)b;
  return (__m128i)spu_emu::detail::Words{x[0], y[0], x[1], y[1]};
}
inline __m128i _mm_unpackhi_epi32(__m128i a, __m128i b) {
  const auto x = (spu_emu::detail::Words)a;
  const auto y = (spu_emu::detail::Words)b;
  return (__m128i)spu_emu::detail::Words{x[2], y[2], x[3], y[3]};
}
inline __m128i _mm_unpackhi_epi64(__m128i a, __m128i b) {
  return __m128i{a[1], b[1]};
}

// By bit 7 of each byte, or the sign of each lane.
inline __m128i _mm_blendv_epi8(__m128i a, __m128i b, __m128i mask) {
  const auto second = (__m128i)((spu_emu::detail::SignedBytes)mask < 0);
  return (a & ~second) | (b & second);
}
inline __m128 _mm_blendv_ps(__m128 a, __m128 b, __m128 mask) {
  const auto second = (__m128i)((spu_emu::detail::SignedWords)mask < 0);
  return (__m128)(((__m128i)a & ~second) | ((__m128i)b & second));
}
inline __m128d _mm_blendv_pd(__m128d a, __m128d b, __m128d mask) {
  const auto second = (__m128i)((__m128i)mask < 0);
  return (__m128d)(((__m128i)a & ~second) | ((__m128i)b & second));
}
// By one bit for each lane.
inline __m128 _mm_blend_ps(__m128 a, __m128 b, int which) {
  return spu_emu::detail::make_lanes<__m128>(
      [&](unsigned lane) { return ((which >> lane) & 1) != 0 ? b[lane] : a[lane]; });
}
inline __m128d _mm_blend_pd(__m128d a, __m128d b, int which) {
  return spu_emu::detail::make_lanes<__m128d>(
      [&](unsigned lane) { return ((which >> lane) & 1) != 0 ? b[lane] : a[lane]; });
}

inline __m128i _mm_blend_epi16(__m128i a, __m128i b, int which) {
  return (__m128i)spu_emu::detail::make_lanes<spu_emu::detail::Halves>(
      [&](unsigned lane) { return ((spu_emu::detail::Halves)(((which >> lane) & 1) != 0 ? b : a))[lane]; });
}

inline __m128i _mm_load_si128(const __m128i* from) {
  return *from;
}
inline void _mm_store_si128(__m128i* to, __m128i v) {
  *to = v;
}

inline int _mm_movemask_epi8(__m128i v) {
  int mask = 0;
  for (unsigned lane = 0; lane < 16; ++lane) mask |= ((spu_emu::detail::Bytes)v)[lane] >> 7 << lane;
  return mask;
}
inline int _mm_movemask_ps(__m128 v) {
  int mask = 0;
  for (unsigned lane = 0; lane < 4; ++lane)
    mask |= static_cast<int>(((spu_emu::detail::Words)v)[lane] >> 31 << lane);
  return mask;
}

#endif
