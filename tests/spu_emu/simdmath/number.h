// Floating-point numbers of the SPU and the PPU as numbers of MPFR, and distances between them.
#pragma once

#include <mpfr.h>

#include <cstdint>

namespace simdmath_test {

/// An MPFR number with room for every sum of two floats or doubles near each other.
class Number {
 public:
  Number() { mpfr_init2(value_, 400); }
  ~Number() { mpfr_clear(value_); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  operator mpfr_ptr() { return value_; }
  operator mpfr_srcptr() const { return value_; }

 private:
  mpfr_t value_;
};

/// What a number of so many bits is: the SPU's floats have no infinity, no NaN and no denormals, those of the
/// PPU's vectors no denormals as Linux sets them; to the SPU's doubles a denormal operand is zero, results
/// may be denormal; the PPU's doubles have everything.
struct Format {
  int fraction_bits;
  int exponent_bits;
  bool has_infinity;
  bool has_denormals;
  bool takes_denormals;

  [[nodiscard]] int bias() const { return (1 << (exponent_bits - 1)) - 1; }
  [[nodiscard]] std::uint64_t largest_exponent() const {
    return (1U << static_cast<unsigned>(exponent_bits)) - 1;
  }
};

constexpr Format kSpuFloat{23, 8, false, false, false};
constexpr Format kPpuFloat{23, 8, true, false, false};
constexpr Format kSpuDouble{52, 11, true, true, false};
constexpr Format kPpuDouble{52, 11, true, true, true};

enum class Kind { number, infinite, none };

Kind kind_of(const Format& format, std::uint64_t bits);
/// An operand as the unit takes it.
std::uint64_t as_operand(const Format& format, std::uint64_t bits);
/// Also of an infinity or a NaN.
void set_to(Number& number, const Format& format, std::uint64_t bits);

/// How far a result is from the exact one, in units of the last place of the exact one. Zero for what is too
/// large or too small and has become what the format has for that; infinite for what is another kind of
/// thing. Where `size` is larger than the exact result, in units of its last place.
double error_of(const Format& format, std::uint64_t result, const Number& exact, const Number& size);

}  // namespace simdmath_test
