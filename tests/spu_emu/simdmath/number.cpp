#include "simdmath/number.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace simdmath_test {

namespace {

std::uint64_t exponent_of(const Format& f, std::uint64_t bits) {
  return bits >> static_cast<unsigned>(f.fraction_bits) & f.largest_exponent();
}
std::uint64_t fraction_of(const Format& f, std::uint64_t bits) {
  return bits & ((std::uint64_t{1} << static_cast<unsigned>(f.fraction_bits)) - 1);
}
bool is_negative(const Format& f, std::uint64_t bits) {
  return (bits >> static_cast<unsigned>(f.fraction_bits + f.exponent_bits) & 1U) != 0;
}

/// The exponent of the smallest normal number, and of the largest.
long smallest(const Format& f) {
  return 1 - f.bias();
}
long largest(const Format& f) {
  return static_cast<long>(f.largest_exponent()) - f.bias() - (f.has_infinity ? 1 : 0);
}

}  // namespace

Kind kind_of(const Format& f, std::uint64_t bits) {
  if (!f.has_infinity || exponent_of(f, bits) != f.largest_exponent()) return Kind::number;
  return fraction_of(f, bits) == 0 ? Kind::infinite : Kind::none;
}

std::uint64_t as_operand(const Format& f, std::uint64_t bits) {
  if (f.takes_denormals || exponent_of(f, bits) != 0) return bits;
  return bits & (std::uint64_t{1} << static_cast<unsigned>(f.fraction_bits + f.exponent_bits));
}

void set_to(Number& number, const Format& f, std::uint64_t bits) {
  const std::uint64_t exponent = exponent_of(f, bits);
  if (kind_of(f, bits) == Kind::none) {
    mpfr_set_nan(number);
  } else if (kind_of(f, bits) == Kind::infinite) {
    mpfr_set_inf(number, 1);
  } else if (exponent == 0) {
    mpfr_set_ui_2exp(number, f.has_denormals ? fraction_of(f, bits) : 0, smallest(f) - f.fraction_bits,
                     MPFR_RNDN);
  } else {
    const std::uint64_t hidden = std::uint64_t{1} << static_cast<unsigned>(f.fraction_bits);
    mpfr_set_ui_2exp(number, hidden | fraction_of(f, bits),
                     static_cast<long>(exponent) - f.bias() - f.fraction_bits, MPFR_RNDN);
  }
  mpfr_setsign(number, number, is_negative(f, bits) ? 1 : 0, MPFR_RNDN);
}

double error_of(const Format& f, std::uint64_t result, const Number& exact, const Number& size) {
  constexpr double kWrong = std::numeric_limits<double>::infinity();
  const Kind kind = kind_of(f, result);
  if (mpfr_nan_p(exact) != 0) {
    if (f.has_infinity) return kind == Kind::none ? 0 : kWrong;
    return (result & 0x7fffffffU) == 0x7fffffffU ? 0 : kWrong;
  }
  if (kind == Kind::none) return kWrong;
  Number value;
  set_to(value, f, result);
  const bool is_largest =
      kind == Kind::infinite || (!f.has_infinity && (result & 0x7fffffffU) == 0x7fffffffU);
  const bool too_large =
      mpfr_inf_p(exact) != 0 || (mpfr_zero_p(exact) == 0 && mpfr_get_exp(exact) - 1 > largest(f));
  if (too_large && is_largest) return mpfr_signbit(value) == mpfr_signbit(exact) ? 0 : kWrong;
  if (mpfr_inf_p(exact) != 0) return kWrong;
  if (kind == Kind::infinite) {
    // As near as rounding brings it.
    Number limit;
    mpfr_set_ui_2exp(limit, 2, largest(f), MPFR_RNDN);
    mpfr_setsign(value, limit, mpfr_signbit(value), MPFR_RNDN);
  }
  // Operands that are passed on as they are.
  if (!f.takes_denormals && mpfr_zero_p(exact) != 0 && exponent_of(f, result) == 0) return 0;
  const bool too_small = mpfr_zero_p(exact) == 0 && mpfr_get_exp(exact) - 1 < smallest(f);
  if (too_small && !f.has_denormals && mpfr_zero_p(value) != 0) return 0;
  const mpfr_srcptr unit_of = mpfr_cmpabs(size, exact) > 0 ? size : exact;
  const long exponent =
      mpfr_zero_p(unit_of) != 0 ? smallest(f) : std::max<long>(mpfr_get_exp(unit_of) - 1, smallest(f));
  mpfr_sub(value, value, exact, MPFR_RNDN);
  mpfr_mul_2si(value, value, f.fraction_bits - exponent, MPFR_RNDN);
  return std::fabs(mpfr_get_d(value, MPFR_RNDN));
}

}  // namespace simdmath_test
