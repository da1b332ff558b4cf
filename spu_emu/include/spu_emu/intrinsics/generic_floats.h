// The part of SSE's floating point that the intrinsics are written in, for processors without it.
//
// Single-precision arithmetic takes denormals for zero and gives zero for them, as SSE does in the mode that
// the SPU needs; the rounding mode is that of <cfenv>.
#ifndef SPU_EMU_INTRINSICS_GENERIC_FLOATS_H
#define SPU_EMU_INTRINSICS_GENERIC_FLOATS_H

#include <cfloat>
#include <cmath>
#include <cstdint>

#include "spu_emu/intrinsics/generic_vectors.h"

namespace spu_emu::detail {

inline float without_denormal(float x) {
  return std::fabs(x) < FLT_MIN ? std::copysign(0.0F, x) : x;
}

// Rounds in the processor's mode. The compiler cannot see where the double is from, or it would work on
// floats by AltiVec, whose own arithmetic rounds to nearest whatever the mode is.
inline float to_float(double x) {
  asm("" : "+m"(x));
  return static_cast<float>(x);
}

// One by one and by way of double, which is exact or, rounding toward zero, rounds to the same in two steps
// as in one.
template <typename Operation>
inline __m128 through_doubles(__m128 a, __m128 b, Operation operation) {
  return make_lanes<__m128>([&](unsigned lane) {
    return without_denormal(to_float(operation(without_denormal(a[lane]), without_denormal(b[lane]))));
  });
}

}  // namespace spu_emu::detail

inline __m128 _mm_add_ps(__m128 a, __m128 b) {
  return spu_emu::detail::through_doubles(a, b, [](double x, double y) { return x + y; });
}
inline __m128 _mm_sub_ps(__m128 a, __m128 b) {
  return spu_emu::detail::through_doubles(a, b, [](double x, double y) { return x - y; });
}
inline __m128 _mm_mul_ps(__m128 a, __m128 b) {
  return spu_emu::detail::through_doubles(a, b, [](double x, double y) { return x * y; });
}
inline __m128d _mm_add_sd(__m128d a, __m128d b) {
  return __m128d{a[0] + b[0], a[1]};
}
inline __m128d _mm_sub_sd(__m128d a, __m128d b) {
  return __m128d{a[0] - b[0], a[1]};
}
inline __m128d _mm_mul_sd(__m128d a, __m128d b) {
  return __m128d{a[0] * b[0], a[1]};
}
inline __m128d _mm_set_sd(double x) {
  return __m128d{x, 0};
}
inline double _mm_cvtsd_f64(__m128d v) {
  return v[0];
}
inline __m128d _mm_add_pd(__m128d a, __m128d b) {
  return a + b;
}
inline __m128d _mm_sub_pd(__m128d a, __m128d b) {
  return a - b;
}
inline __m128d _mm_mul_pd(__m128d a, __m128d b) {
  return a * b;
}

inline __m128d _mm_cvtps_pd(__m128 v) {
  return __m128d{v[0], v[1]};
}
inline __m128 _mm_cvtpd_ps(__m128d v) {
  return __m128{spu_emu::detail::to_float(v[0]), spu_emu::detail::to_float(v[1]), 0, 0};
}
inline __m128 _mm_cvtepi32_ps(__m128i v) {
  namespace d = spu_emu::detail;
  return d::make_lanes<__m128>([&](unsigned lane) { return d::to_float(((d::SignedWords)v)[lane]); });
}
inline __m128i _mm_cvtepi32_epi64(__m128i v) {
  return __m128i{((spu_emu::detail::SignedWords)v)[0], ((spu_emu::detail::SignedWords)v)[1]};
}
// What does not fit is 0x80000000.
inline __m128i _mm_cvttps_epi32(__m128 v) {
  return (__m128i)spu_emu::detail::make_lanes<spu_emu::detail::SignedWords>([&](unsigned lane) {
    return v[lane] > -2147483904.0F && v[lane] < 2147483648.0F ? static_cast<int>(v[lane]) : INT32_MIN;
  });
}

#endif
