// Reciprocal and reciprocal square root estimates: spu_frest, spu_frsqest, and interpolated spu_re,
// spu_rsqrte.
//
// An estimate instruction gives a packed line: sign, exponent, 13 bits of base fraction and 10 bits of step
// (weight 2^-13). Floating interpolate evaluates base - step * y, y being the argument's low 19 fraction bits
// as a fraction, truncated. The line tables are the contents of the hardware's own, indexed by the leading
// fraction bits: a segment of sixteen holds two lines where the curve is steep, the same one twice elsewhere.
// All integer arithmetic, so the results depend on no MXCSR.
#ifndef SPU_EMU_INTRINSICS_ESTIMATE_H
#define SPU_EMU_INTRINSICS_ESTIMATE_H

#include "spu_emu/intrinsics/traits.h"

namespace spu_emu::detail {

// Indexed by the five leading fraction bits.
constexpr unsigned int reciprocal_lines[32] = {
    0x7ffbe0, 0x7f87a6, 0x70ef72, 0x708b40, 0x638b12, 0x633aea, 0x5792c4, 0x574aa0,
    0x4cca7e, 0x4c9262, 0x430a44, 0x42d62a, 0x3a2e12, 0x39fdfa, 0x3215e4, 0x31f1d2,
    0x2aa9be, 0x2a85ac, 0x23d59a, 0x23bd8e, 0x1d8576, 0x1d8576, 0x17ad5a, 0x17ad5a,
    0x124543, 0x124543, 0x0d392d, 0x0d392d, 0x08851a, 0x08851a, 0x041d07, 0x041d07};

// Indexed by the lowest exponent bit and the five leading fraction bits.
constexpr unsigned int root_lines[64] = {
    0x350160, 0x34e954, 0x2f993d, 0x2f993d, 0x2aa523, 0x2aa523, 0x26190d, 0x26190d, 0x21e4f9, 0x21e4f9,
    0x1e00e9, 0x1e00e9, 0x1a5cd9, 0x1a5cd9, 0x16f8cb, 0x16f8cb, 0x13ccc0, 0x13ccc0, 0x10ccb3, 0x10ccb3,
    0x0e00aa, 0x0e00aa, 0x0b58a1, 0x0b58a1, 0x08d498, 0x08d498, 0x067491, 0x067491, 0x043089, 0x043089,
    0x020c83, 0x020c83, 0x7ffdf4, 0x7fd1de, 0x7859c8, 0x783dba, 0x71559c, 0x71559c, 0x6ae57c, 0x6ae57c,
    0x64f561, 0x64f561, 0x5f7149, 0x5f7149, 0x5a4d33, 0x5a4d33, 0x55811f, 0x55811f, 0x51050f, 0x51050f,
    0x4cc8fe, 0x4cc8fe, 0x48d0f0, 0x48d0f0, 0x4510e4, 0x4510e4, 0x4180d7, 0x4180d7, 0x3e24cc, 0x3e24cc,
    0x3af4c3, 0x3af4c3, 0x37e8ba, 0x37e8ba};

SPU_EMU_INLINE vec_uint4 look_up(const unsigned int* lines, vec_uint4 index) {
  return vec_uint4{lines[index[0]], lines[index[1]], lines[index[2]], lines[index[3]]};
}

SPU_EMU_INLINE vec_uint4 exponent_field(vec_uint4 b) {
  return (b >> 23) & splat<vec_uint4>(255);
}

// base - step * y. The difference, in units of 2^-24, is truncated; below 1 it is shifted up by its one
// missing bit.
SPU_EMU_INLINE vec_float4 interpolate(vec_float4 argument, vec_float4 line) {
  const vec_uint4 b = (vec_uint4)line;
  const vec_uint4 base = ((b >> 10) & splat<vec_uint4>(0x1fff)) | splat<vec_uint4>(0x2000);
  const vec_uint4 y = (vec_uint4)argument & splat<vec_uint4>(0x7ffff);
  const vec_uint4 product = (vec_uint4)_mm_mullo_epi32((__m128i)(b & splat<vec_uint4>(0x3ff)), (__m128i)y);
  const vec_uint4 value = (base << 11) - ((product + splat<vec_uint4>(255)) >> 8);
  const vec_uint4 below_one = (vec_uint4)(value < splat<vec_uint4>(1 << 24));
  const vec_uint4 fraction = ((value & below_one) | ((value >> 1) & ~below_one)) & splat<vec_uint4>(0x7fffff);
  const vec_uint4 head = (b & splat<vec_uint4>(0xff800000U)) - (below_one & splat<vec_uint4>(1 << 23));
  const vec_uint4 nonzero = (vec_uint4)(exponent_field(b) + below_one != splat<vec_uint4>(0));
  const vec_uint4 line_nonzero = (vec_uint4)(exponent_field(b) != splat<vec_uint4>(0));
  return (vec_float4)((head | fraction) & nonzero & line_nonzero);
}

}  // namespace spu_emu::detail

// Not an estimate by itself: the line to be interpolated. Arguments from 2^126 on give exponent 0, zeros 255.
SPU_EMU_INLINE vec_float4 spu_frest(vec_float4 a) {
  namespace d = spu_emu::detail;
  const vec_uint4 b = (vec_uint4)a;
  const vec_uint4 exponent = d::exponent_field(b);
  const vec_uint4 fraction = d::look_up(d::reciprocal_lines, (b >> 18) & d::splat<vec_uint4>(31));
  const __m128i difference = _mm_sub_epi32(_mm_set1_epi32(253), (__m128i)exponent);
  const vec_uint4 result = (vec_uint4)_mm_max_epi32(difference, _mm_setzero_si128());
  const vec_uint4 of_zero = (vec_uint4)(exponent == d::splat<vec_uint4>(0)) & d::splat<vec_uint4>(255);
  return (vec_float4)((b & d::splat<vec_uint4>(0x80000000U)) | ((result | of_zero) << 23) | fraction);
}

// The argument's sign is ignored and the result positive.
SPU_EMU_INLINE vec_float4 spu_frsqest(vec_float4 a) {
  namespace d = spu_emu::detail;
  const vec_uint4 b = (vec_uint4)a;
  const vec_uint4 exponent = d::exponent_field(b);
  const vec_uint4 fraction = d::look_up(d::root_lines, (b >> 18) & d::splat<vec_uint4>(63));
  const vec_uint4 result = d::splat<vec_uint4>(190) - ((exponent + d::splat<vec_uint4>(1)) >> 1);
  const vec_uint4 of_zero = (vec_uint4)(exponent == d::splat<vec_uint4>(0)) & d::splat<vec_uint4>(255);
  return (vec_float4)(((result | of_zero) << 23) | fraction);
}

// About 12 correct bits of 1 / a.
SPU_EMU_INLINE vec_float4 spu_re(vec_float4 a) {
  return spu_emu::detail::interpolate(a, spu_frest(a));
}

// About 12 correct bits of 1 / sqrt(|a|).
SPU_EMU_INLINE vec_float4 spu_rsqrte(vec_float4 a) {
  return spu_emu::detail::interpolate(a, spu_frsqest(a));
}

#endif
