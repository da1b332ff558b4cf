// Double-precision arithmetic and compares: IEEE results in the rounding mode of the FPSCR, nearest by
// default.
//
// As recorded on hardware: denormal operands count as zeros of their sign, denormal results stay, every NaN
// result is 0x7ff8000000000000, multiply-adds round once, and spu_nmadd/spu_nmsub negate the finished result
// (so that spu_nmsub of equal terms is -0). Exception flags of the FPSCR are not kept. Works under any MXCSR:
// each operation sets the mode it needs and puts the caller's back, which costs some tens of cycles.
#ifndef SPU_EMU_INTRINSICS_DOUBLE_H
#define SPU_EMU_INTRINSICS_DOUBLE_H

#include "spu_emu/intrinsics/float_mode.h"
#include "spu_emu/intrinsics/traits.h"
#include "spu_emu/special_values.h"

namespace spu_emu::detail {

// Rounding of each of the two slots, as the FPSCR numbers them: 0 nearest, 1 toward zero, 2 up, 3 down.
struct DoubleRounding {
  unsigned int slot[2] = {0, 0};
};

inline DoubleRounding& double_rounding() {
  thread_local DoubleRounding rounding;
  return rounding;
}

#ifdef __SSE4_1__
// MXCSR for one of the FPSCR's modes: exceptions masked, nothing flushed.
SPU_EMU_INLINE unsigned int double_mxcsr(unsigned int mode) {
  constexpr unsigned int control[4] = {0x1f80, 0x7f80, 0x5f80, 0x3f80};
  return control[mode & 3];
}

// The operands pass through both mode changes, which keeps the compiler from moving or folding what lies
// between.
SPU_EMU_INLINE void load_mxcsr(unsigned int value, __m128d& a, __m128d& b, __m128d& c) {
  asm volatile("ldmxcsr %3" : "+x"(a), "+x"(b), "+x"(c) : "m"(value));
}

SPU_EMU_INLINE void load_mxcsr(unsigned int value, __m128d& a) {
  asm volatile("ldmxcsr %1" : "+x"(a) : "m"(value));
}
#else
// How <cfenv> names one of the FPSCR's modes.
SPU_EMU_INLINE int double_rounding_mode(unsigned int mode) {
  constexpr int names[4] = {FE_TONEAREST, FE_TOWARDZERO, FE_UPWARD, FE_DOWNWARD};
  return names[mode & 3];
}

// The operands pass through, which keeps the compiler from moving or folding what follows.
SPU_EMU_INLINE void set_rounding(int mode, __m128d& a, __m128d& b, __m128d& c) {
  std::fesetround(mode);
  asm volatile("" : "+m"(a), "+m"(b), "+m"(c));
}

// The result passes through before the mode changes.
SPU_EMU_INLINE void set_rounding(int mode, __m128d& a) {
  asm volatile("" : "+m"(a));
  std::fesetround(mode);
}
#endif

SPU_EMU_INLINE __m128d flush_denormal(__m128d v) {
  const __m128i b = _mm_castpd_si128(v);
  constexpr int high_words = is_big_endian ? _MM_SHUFFLE(2, 2, 0, 0) : _MM_SHUFFLE(3, 3, 1, 1);
  const __m128i exponent = _mm_and_si128(_mm_shuffle_epi32(b, high_words), _mm_set1_epi32(0x7ff00000));
  const __m128i is_zero = _mm_cmpeq_epi32(exponent, _mm_setzero_si128());
  return _mm_castsi128_pd(_mm_andnot_si128(_mm_and_si128(is_zero, _mm_set1_epi64x(INT64_MAX)), b));
}

SPU_EMU_INLINE __m128d default_nan(__m128d v) {
  const __m128d nan = _mm_castsi128_pd(_mm_set1_epi64x(0x7ff8000000000000));
  return _mm_blendv_pd(v, nan, _mm_cmpunord_pd(v, v));
}

// Rounds once, whatever the instruction set; without FMA instructions the C library's fma.
SPU_EMU_INLINE __m128d fused_multiply_add(__m128d a, __m128d b, __m128d c) {
#ifdef __FMA__
  return _mm_fmadd_pd(a, b, c);
#else
  return _mm_setr_pd(__builtin_fma(a[0], b[0], c[0]), __builtin_fma(a[1], b[1], c[1]));
#endif
}

template <typename Operation>
SPU_EMU_INLINE __m128d rounded(unsigned int mode, Operation operation, __m128d a, __m128d b, __m128d c) {
  const FloatControl caller = float_control();
#ifdef __SSE4_1__
  load_mxcsr(double_mxcsr(mode), a, b, c);
  __m128d result = operation(a, b, c);
  load_mxcsr(caller, result);
#else
  set_rounding(double_rounding_mode(mode), a, b, c);
  __m128d result = operation(a, b, c);
  set_rounding(caller, result);
#endif
  return result;
}

// The operation on flushed operands in each slot's rounding, before any NaN is replaced.
template <typename Operation>
SPU_EMU_INLINE __m128d double_operation(Operation operation, vec_double2 a, vec_double2 b, vec_double2 c) {
  const __m128d x = flush_denormal((__m128d)a);
  const __m128d y = flush_denormal((__m128d)b);
  const __m128d z = flush_denormal((__m128d)c);
  const DoubleRounding mode = double_rounding();
  const __m128d first = rounded(mode.slot[0], operation, x, y, z);
  if (__builtin_expect(mode.slot[0] == mode.slot[1], 1)) return first;
  return _mm_blend_pd(first, rounded(mode.slot[1], operation, x, y, z), 2);
}

SPU_EMU_INLINE __m128d multiply_add(vec_double2 a, vec_double2 b, vec_double2 c) {
  return double_operation([](__m128d x, __m128d y, __m128d z) { return fused_multiply_add(x, y, z); }, a, b,
                          c);
}

SPU_EMU_INLINE __m128d flip_sign(__m128d v) {
  return _mm_xor_pd(v, _mm_set1_pd(-0.0));
}

}  // namespace spu_emu::detail

SPU_EMU_INLINE vec_double2 spu_add(vec_double2 a, vec_double2 b) {
  namespace d = spu_emu::detail;
  const auto operation = [](__m128d x, __m128d y, __m128d) { return _mm_add_pd(x, y); };
  return (vec_double2)d::default_nan(d::double_operation(operation, a, b, b));
}

SPU_EMU_INLINE vec_double2 spu_sub(vec_double2 a, vec_double2 b) {
  namespace d = spu_emu::detail;
  const auto operation = [](__m128d x, __m128d y, __m128d) { return _mm_sub_pd(x, y); };
  return (vec_double2)d::default_nan(d::double_operation(operation, a, b, b));
}

SPU_EMU_INLINE vec_double2 spu_mul(vec_double2 a, vec_double2 b) {
  namespace d = spu_emu::detail;
  const auto operation = [](__m128d x, __m128d y, __m128d) { return _mm_mul_pd(x, y); };
  return (vec_double2)d::default_nan(d::double_operation(operation, a, b, b));
}

// a * b + c.
SPU_EMU_INLINE vec_double2 spu_madd(vec_double2 a, vec_double2 b, vec_double2 c) {
  namespace d = spu_emu::detail;
  return (vec_double2)d::default_nan(d::multiply_add(a, b, c));
}

// a * b - c.
SPU_EMU_INLINE vec_double2 spu_msub(vec_double2 a, vec_double2 b, vec_double2 c) {
  return spu_madd(a, b, (vec_double2)spu_emu::detail::flip_sign((__m128d)c));
}

// -(a * b + c).
SPU_EMU_INLINE vec_double2 spu_nmadd(vec_double2 a, vec_double2 b, vec_double2 c) {
  namespace d = spu_emu::detail;
  return (vec_double2)d::default_nan(d::flip_sign(d::multiply_add(a, b, c)));
}

// -(a * b - c).
SPU_EMU_INLINE vec_double2 spu_nmsub(vec_double2 a, vec_double2 b, vec_double2 c) {
  return spu_nmadd(a, b, (vec_double2)spu_emu::detail::flip_sign((__m128d)c));
}

// The scalar form of spu_madd.
SPU_EMU_INLINE double dfmas(double a, double b, double c) {
  return spu_madd(vec_double2{a, a}, vec_double2{b, b}, vec_double2{c, c})[0];
}

// Compares count denormals as zero, too; NaN is neither equal to nor greater than anything.
SPU_EMU_INLINE vec_ullong2 spu_cmpeq(vec_double2 a, vec_double2 b) {
  namespace d = spu_emu::detail;
  return (vec_ullong2)_mm_cmpeq_pd(d::flush_denormal((__m128d)a), d::flush_denormal((__m128d)b));
}

SPU_EMU_INLINE vec_ullong2 spu_cmpgt(vec_double2 a, vec_double2 b) {
  namespace d = spu_emu::detail;
  return (vec_ullong2)_mm_cmpgt_pd(d::flush_denormal((__m128d)a), d::flush_denormal((__m128d)b));
}

namespace spu_emu::detail {

SPU_EMU_INLINE vec_double2 magnitude(vec_double2 v) {
  return (vec_double2)_mm_andnot_pd(_mm_set1_pd(-0.0), (__m128d)v);
}

}  // namespace spu_emu::detail

SPU_EMU_INLINE vec_ullong2 spu_cmpabseq(vec_double2 a, vec_double2 b) {
  return spu_cmpeq(spu_emu::detail::magnitude(a), spu_emu::detail::magnitude(b));
}

SPU_EMU_INLINE vec_ullong2 spu_cmpabsgt(vec_double2 a, vec_double2 b) {
  return spu_cmpgt(spu_emu::detail::magnitude(a), spu_emu::detail::magnitude(b));
}

namespace spu_emu::detail {

// The SPU_SV_ bit that describes a double.
SPU_EMU_INLINE int special_value_of(unsigned long long b) {
  const bool negative = b >> 63 != 0;
  const unsigned long long exponent = (b >> 52) & 0x7ff;
  const unsigned long long fraction = b & 0xfffffffffffff;
  if (exponent == 0x7ff && fraction != 0) return SPU_SV_NAN;
  if (exponent == 0x7ff) return negative ? SPU_SV_NEG_INFINITY : SPU_SV_POS_INFINITY;
  if (exponent != 0) return 0;
  if (fraction != 0) return negative ? SPU_SV_NEG_DENORM : SPU_SV_POS_DENORM;
  return negative ? SPU_SV_NEG_ZERO : SPU_SV_POS_ZERO;
}

}  // namespace spu_emu::detail

// All ones where the double is of a kind that `kinds`, an OR of SPU_SV_ bits, names.
SPU_EMU_INLINE vec_ullong2 spu_testsv(vec_double2 v, int kinds) {
  const vec_ullong2 b = (vec_ullong2)v;
  const auto test = [&](unsigned long long e) {
    return (spu_emu::detail::special_value_of(e) & kinds) != 0 ? ~0ULL : 0ULL;
  };
  return vec_ullong2{test(b[0]), test(b[1])};
}

#endif
