/// @file
/// Upper bounds from arithmetic that truncates: exact results stay as they are, others go up by one step
/// (F3). SPU side only; operands are finite, with zeros for denormals.
#pragma once

#include <spu_intrinsics.h>

namespace cellsweep::cell {

/// Below these, remainders may be too small for a float, and no compare can trust them.
constexpr float kTinyProduct = 0x1p-76F;
constexpr float kTinyProductError = 0x1p-99F;  // more than any tiny product loses
constexpr float kTinyDividend = 0x1p-70F;

inline vec_float4 zeros() {
  return spu_splats(0.0F);
}

inline vec_float4 negative(vec_float4 v) {
  return (vec_float4)spu_xor((vec_uint4)v, spu_splats(0x80000000U));
}

inline vec_float4 magnitude(vec_float4 v) {
  return (vec_float4)spu_and((vec_uint4)v, spu_splats(0x7fffffffU));
}

inline vec_float4 greater(vec_float4 a, vec_float4 b) {
  return spu_sel(a, b, spu_cmpgt(b, a));
}

/// The next number away from zero in the lanes of the mask, and +0 for every zero that stays.
inline vec_float4 step_away(vec_float4 v, vec_uint4 where) {
  const vec_uint4 least_normal = spu_splats(0x00800000U);
  const vec_uint4 stepped = spu_sub((vec_uint4)v, where);  // a mask is −1
  return (vec_float4)spu_sel(stepped, spu_and(where, least_normal), spu_cmpeq(v, zeros()));
}

/// A truncated product, and what it is away from a·b at most.
struct Product {
  vec_float4 value;
  vec_float4 error;
};

inline Product product(vec_float4 a, vec_float4 b) {
  const vec_float4 value = spu_mul(a, b);
  const vec_uint4 no_zero = spu_nor(spu_cmpeq(a, zeros()), spu_cmpeq(b, zeros()));
  const vec_uint4 tiny = spu_and(spu_cmpabsgt(spu_splats(kTinyProduct), value), no_zero);
  const vec_float4 remainder = magnitude(spu_msub(a, b, value));
  return {value, spu_sel(remainder, spu_splats(kTinyProductError), tiny)};
}

/// a·b rounded up; both are 0 or more.
inline vec_float4 product_up(vec_float4 a, vec_float4 b) {
  const Product both = product(a, b);
  return step_away(both.value, spu_cmpgt(both.error, zeros()));
}

/// A truncated sum, and exactly what of the smaller operand went into it: the difference to the larger one
/// always is a float (Dekker).
struct Sum {
  Sum(vec_float4 a, vec_float4 b) : value(spu_add(a, b)) {
    const vec_uint4 swapped = spu_cmpabsgt(b, a);
    smaller = spu_sel(b, a, swapped);
    used = spu_sub(value, spu_sel(a, b, swapped));
  }

  vec_float4 value;
  vec_float4 smaller;
  vec_float4 used;
};

/// |a + b| rounded up.
inline vec_float4 magnitude_of_sum_up(vec_float4 a, vec_float4 b) {
  const Sum sum(a, b);
  const vec_uint4 exact = spu_cmpeq(sum.used, sum.smaller);
  return step_away(magnitude(sum.value), spu_nor(exact, exact));
}

/// a + b rounded up, of any sign.
inline vec_float4 sum_up(vec_float4 a, vec_float4 b) {
  const Sum sum(a, b);
  return step_away(sum.value, spu_cmpgt(sum.smaller, sum.used));
}

/// a/b or a step or two more; a is 0 or more, b from 2^-21 to 2^21.
inline vec_float4 quotient_up(vec_float4 a, vec_float4 b) {
  vec_float4 reciprocal = spu_re(b);
  reciprocal = spu_madd(spu_nmsub(reciprocal, b, spu_splats(1.0F)), reciprocal, reciprocal);
  vec_float4 quotient = spu_mul(a, reciprocal);
  quotient = spu_madd(spu_nmsub(quotient, b, a), reciprocal, quotient);
  // Now less than two steps off; the sign of a remainder is exact.
  quotient = step_away(quotient, spu_cmpgt(spu_nmsub(quotient, b, a), zeros()));
  quotient = step_away(quotient, spu_cmpgt(spu_nmsub(quotient, b, a), zeros()));
  const vec_float4 wider = spu_madd(quotient, spu_splats(1.00001F), spu_splats(0x1p-120F));
  const vec_uint4 tiny = spu_and(spu_cmpgt(spu_splats(kTinyDividend), a), spu_cmpgt(a, zeros()));
  return spu_sel(quotient, wider, tiny);
}

}  // namespace cellsweep::cell
