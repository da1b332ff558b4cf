// Exact binary arithmetic for the references: sums of products m * 2^e in a long fixed-point number, rounded
// once.
#pragma once

#include <array>
#include <cstdint>

namespace reference {

__extension__ using Wide = unsigned __int128;

enum class Rounding { nearest, toward_zero, up, down };

// sign * mantissa * 2^exponent.
struct Term {
  bool negative = false;
  std::uint64_t mantissa = 0;
  int exponent = 0;
};

// A sum of terms and products of terms, two's complement, with bit 0 worth 2^-2200.
class ExactSum {
 public:
  void add(const Term& t);
  void add_product(const Term& a, const Term& b);

  bool is_zero() const;
  bool is_negative() const;

  // The magnitude as mantissa * 2^exponent with `bits` significant bits, or fewer so that the exponent is not
  // below `least_exponent`, rounded by the mode and the sign. A carry leaves 2^bits.
  Term rounded(int bits, int least_exponent, Rounding mode) const;

 private:
  static constexpr int bias = 2200;
  static constexpr std::size_t limb_count = 72;
  void add_shifted(Wide magnitude, int shift, bool negative);
  ExactSum magnitude() const;
  bool bit(int position) const;
  // Of a number that is not zero.
  int highest_bit() const;
  int lowest_bit() const;
  std::array<std::uint64_t, limb_count> limbs_{};
};

// Single precision as the SPU has it: every exponent but 0 is ordinary, results truncate, zero is +0.
Term spu_float_term(std::uint32_t bits);
std::uint32_t spu_float_from(const ExactSum& sum);
std::uint32_t spu_madd(std::uint32_t a, std::uint32_t b, std::uint32_t c);

// Double precision on an SPU: a * b + c by the rules of its dfma, in the given rounding.
std::uint64_t spu_double_madd(std::uint64_t a, std::uint64_t b, std::uint64_t c, Rounding mode);
std::uint64_t spu_double_add(std::uint64_t a, std::uint64_t b, Rounding mode);
std::uint64_t spu_double_multiply(std::uint64_t a, std::uint64_t b, Rounding mode);

constexpr std::uint64_t default_nan = 0x7ff8000000000000;
bool is_nan(std::uint64_t bits);

}  // namespace reference
