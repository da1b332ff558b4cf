#include "simdmath/references.h"

namespace simdmath_test {

namespace {

constexpr mpfr_rnd_t kNearest = MPFR_RNDN;

using Unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using Binary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
using ToWhole = int (*)(mpfr_ptr, mpfr_srcptr);

template <Unary function>
void unary(Number& result, const Number& x, const Number&, const Number&) {
  function(result, x, kNearest);
}
template <Binary function>
void binary(Number& result, const Number& x, const Number& y, const Number&) {
  function(result, x, y, kNearest);
}
template <ToWhole function>
void to_whole(Number& result, const Number& x, const Number&, const Number&) {
  function(result, x);
}

void fma(Number& result, const Number& x, const Number& y, const Number& z) {
  mpfr_fma(result, x, y, z, kNearest);
}
void reciprocal(Number& result, const Number& x, const Number&, const Number&) {
  mpfr_ui_div(result, 1, x, kNearest);
}
void remainder_toward_zero(Number& result, const Number& x, const Number& y, const Number&) {
  mpfr_fmod(result, x, y, kNearest);
}
void sine(Number& result, const Number& x, const Number&, const Number&) {
  mpfr_sin(result, x, kNearest);
}
void cosine(Number& result, const Number& x, const Number&, const Number&) {
  mpfr_cos(result, x, kNearest);
}
/// Twice the bits of a double: with all of a Number's the gamma functions take minutes.
class GammaNumber {
 public:
  GammaNumber() { mpfr_init2(value, 120); }
  ~GammaNumber() { mpfr_clear(value); }
  GammaNumber(const GammaNumber&) = delete;
  GammaNumber& operator=(const GammaNumber&) = delete;
  mpfr_t value;
};
void logarithm_of_gamma(Number& result, const Number& x, const Number&, const Number&) {
  int sign = 0;
  GammaNumber narrow;
  mpfr_lgamma(narrow.value, &sign, x, kNearest);
  mpfr_set(result, narrow.value, kNearest);
}
void gamma(Number& result, const Number& x, const Number&, const Number&) {
  const bool is_fraction = mpfr_number_p(x) != 0 && mpfr_integer_p(x) == 0;
  if (is_fraction && mpfr_cmpabs_ui(x, 500) > 0) {
    // Too large or too small, and slow to find out.
    if (mpfr_sgn(static_cast<mpfr_srcptr>(x)) > 0) return mpfr_set_inf(result, 1);
    return static_cast<void>(mpfr_set_zero(result, 1));
  }
  GammaNumber narrow;
  mpfr_gamma(narrow.value, x, kNearest);
  mpfr_set(result, narrow.value, kNearest);
}
/// Between the poles left of -2 the logarithm has zeros, where it is a difference of terms of this size, or
/// of 1.
void size_of_logarithm_of_gamma(Number& result, const Number& x) {
  mpfr_set_zero(result, 1);
  if (mpfr_sgn(static_cast<mpfr_srcptr>(x)) >= 0) return;
  Number magnitude;
  mpfr_neg(magnitude, x, kNearest);
  logarithm_of_gamma(result, magnitude, magnitude, magnitude);
  if (mpfr_cmp_ui(result, 1) < 0) mpfr_set_ui(result, 1, kNearest);
}
void fraction(Number& result, const Number& x, const Number&, const Number&) {
  mpfr_frac(result, x, kNearest);
}

}  // namespace

const std::vector<Reference>& references() {
  static const std::vector<Reference> all = {
      {"acos", 1, unary<mpfr_acos>},
      {"acosh", 1, unary<mpfr_acosh>},
      {"asin", 1, unary<mpfr_asin>},
      {"asinh", 1, unary<mpfr_asinh>},
      {"atan", 1, unary<mpfr_atan>},
      {"atanh", 1, unary<mpfr_atanh>},
      {"atan2", 2, binary<mpfr_atan2>},
      {"cbrt", 1, unary<mpfr_cbrt>},
      {"ceil", 1, to_whole<mpfr_ceil>},
      {"copysign", 2, binary<mpfr_copysign>},
      {"cos", 1, cosine},
      {"cosh", 1, unary<mpfr_cosh>},
      {"div", 2, binary<mpfr_div>},
      {"erf", 1, unary<mpfr_erf>},
      {"erfc", 1, unary<mpfr_erfc>},
      {"exp", 1, unary<mpfr_exp>},
      {"exp2", 1, unary<mpfr_exp2>},
      {"expm1", 1, unary<mpfr_expm1>},
      {"fabs", 1, unary<mpfr_abs>},
      {"fdim", 2, binary<mpfr_dim>},
      {"floor", 1, to_whole<mpfr_floor>},
      {"fma", 3, fma},
      {"fmax", 2, binary<mpfr_max>},
      {"fmin", 2, binary<mpfr_min>},
      {"fmod", 2, remainder_toward_zero},
      {"hypot", 2, binary<mpfr_hypot>},
      {"lgamma", 1, logarithm_of_gamma, false, size_of_logarithm_of_gamma},
      {"log", 1, unary<mpfr_log>},
      {"log10", 1, unary<mpfr_log10>},
      {"log1p", 1, unary<mpfr_log1p>},
      {"log2", 1, unary<mpfr_log2>},
      {"modf", 1, fraction},
      {"modf", 1, to_whole<mpfr_trunc>, true},
      {"negate", 1, unary<mpfr_neg>},
      {"pow", 2, binary<mpfr_pow>},
      {"recip", 1, reciprocal},
      {"remainder", 2, binary<mpfr_remainder>},
      {"remquo", 2, binary<mpfr_remainder>},
      {"round", 1, to_whole<mpfr_round>},
      {"rsqrt", 1, unary<mpfr_rec_sqrt>},
      {"sin", 1, sine},
      {"sincos", 1, sine},
      {"sincos", 1, cosine, true},
      {"sinh", 1, unary<mpfr_sinh>},
      {"sqrt", 1, unary<mpfr_sqrt>},
      {"tan", 1, unary<mpfr_tan>},
      {"tanh", 1, unary<mpfr_tanh>},
      {"tgamma", 1, gamma},
      {"trunc", 1, to_whole<mpfr_trunc>},
  };
  return all;
}

}  // namespace simdmath_test
