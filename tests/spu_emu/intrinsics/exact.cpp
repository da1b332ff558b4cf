#include "exact.h"

#include <algorithm>

namespace reference {

void ExactSum::add_shifted(Wide magnitude, int shift, bool negative) {
  // Three limbs hold a 128-bit number at any bit offset; subtraction adds the complement and one.
  const std::size_t first = static_cast<std::size_t>(shift / 64);
  const int offset = shift % 64;
  const auto low = static_cast<std::uint64_t>(magnitude);
  const auto high = static_cast<std::uint64_t>(magnitude >> 64);
  const std::uint64_t spill = offset == 0 ? 0 : 64 - static_cast<unsigned>(offset);
  const std::uint64_t parts[3] = {low << offset, (high << offset) | (offset == 0 ? 0 : low >> spill),
                                  offset == 0 ? 0 : high >> spill};
  Wide carry = negative ? 1 : 0;
  for (std::size_t k = 0; k < limb_count; ++k) {
    const std::uint64_t part = k >= first && k < first + 3 ? parts[k - first] : 0;
    carry += static_cast<Wide>(limbs_[k]) + (negative ? ~part : part);
    limbs_[k] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
}

void ExactSum::add(const Term& t) {
  if (t.mantissa != 0) add_shifted(t.mantissa, t.exponent + bias, t.negative);
}

void ExactSum::add_product(const Term& a, const Term& b) {
  const Wide product = static_cast<Wide>(a.mantissa) * b.mantissa;
  if (product != 0) add_shifted(product, a.exponent + b.exponent + bias, a.negative != b.negative);
}

bool ExactSum::is_zero() const {
  return std::all_of(limbs_.begin(), limbs_.end(), [](std::uint64_t limb) { return limb == 0; });
}

bool ExactSum::is_negative() const {
  return limbs_.back() >> 63 != 0;
}

ExactSum ExactSum::magnitude() const {
  if (!is_negative()) return *this;
  ExactSum result;
  Wide carry = 1;
  for (std::size_t k = 0; k < limb_count; ++k) {
    carry += static_cast<std::uint64_t>(~limbs_[k]);
    result.limbs_[k] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  return result;
}

bool ExactSum::bit(int position) const {
  return position >= 0 && (limbs_[static_cast<std::size_t>(position / 64)] >> (position % 64) & 1) != 0;
}

int ExactSum::highest_bit() const {
  std::size_t k = limb_count - 1;
  while (limbs_[k] == 0) --k;
  return 64 * static_cast<int>(k) + 63 - __builtin_clzll(limbs_[k]);
}

int ExactSum::lowest_bit() const {
  std::size_t k = 0;
  while (limbs_[k] == 0) ++k;
  return 64 * static_cast<int>(k) + __builtin_ctzll(limbs_[k]);
}

Term ExactSum::rounded(int bits, int least_exponent, Rounding mode) const {
  const ExactSum m = magnitude();
  const int top = m.highest_bit();
  const int lowest = std::max(top - bits + 1, least_exponent + bias);
  Term t{is_negative(), 0, lowest - bias};
  for (int k = top; k >= lowest; --k) t.mantissa = t.mantissa << 1 | (m.bit(k) ? 1 : 0);
  const bool rest = m.lowest_bit() < lowest - 1;
  const bool half = m.bit(lowest - 1);
  const bool nearest_up = half && (rest || (t.mantissa & 1) != 0);
  const bool away = (half || rest) && mode == (t.negative ? Rounding::down : Rounding::up);
  if (mode == Rounding::nearest ? nearest_up : away) ++t.mantissa;
  return t;
}

Term spu_float_term(std::uint32_t bits) {
  const int exponent = static_cast<int>(bits >> 23 & 255);
  if (exponent == 0) return {bits >> 31 != 0, 0, 0};
  return {bits >> 31 != 0, (bits & 0x7fffff) | 0x800000, exponent - 150};
}

std::uint32_t spu_float_from(const ExactSum& sum) {
  if (sum.is_zero()) return 0;
  const Term t = sum.rounded(24, -100000, Rounding::toward_zero);
  const int exponent = t.exponent + 150;
  const std::uint32_t sign = t.negative ? 0x80000000U : 0;
  if (exponent <= 0) return 0;
  if (exponent > 255) return sign | 0x7fffffffU;
  return sign | static_cast<std::uint32_t>(exponent) << 23 |
         static_cast<std::uint32_t>(t.mantissa & 0x7fffff);
}

std::uint32_t spu_madd(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  ExactSum sum;
  sum.add_product(spu_float_term(a), spu_float_term(b));
  sum.add(spu_float_term(c));
  return spu_float_from(sum);
}

bool is_nan(std::uint64_t bits) {
  return (bits & 0x7fffffffffffffff) > 0x7ff0000000000000;
}

namespace {

constexpr std::uint64_t sign_bit = 0x8000000000000000;
constexpr std::uint64_t infinity = 0x7ff0000000000000;

bool is_infinite(std::uint64_t b) {
  return (b & ~sign_bit) == infinity;
}
bool is_zero(std::uint64_t b) {
  return (b & infinity) == 0;
}  // denormal operands are zeros, too
std::uint64_t sign_of(std::uint64_t b) {
  return b & sign_bit;
}

Term double_term(std::uint64_t b) {
  if (is_zero(b)) return {sign_of(b) != 0, 0, 0};
  const int exponent = static_cast<int>(b >> 52 & 0x7ff);
  return {sign_of(b) != 0, (b & 0xfffffffffffff) | 1ULL << 52, exponent - 1075};
}

// Largest finite number or infinity, as the rounding mode has it for an overflow of this sign.
std::uint64_t overflow(bool negative, Rounding mode) {
  const bool to_infinity = mode == Rounding::nearest || mode == (negative ? Rounding::down : Rounding::up);
  return (negative ? sign_bit : 0) | (to_infinity ? infinity : infinity - 1);
}

std::uint64_t double_from(const ExactSum& sum, Rounding mode) {
  const Term t = sum.rounded(53, -1074, mode);
  const std::uint64_t sign = t.negative ? sign_bit : 0;
  // A mantissa of 53 bits adds its top bit into the exponent field, also when rounding carried into it.
  if (t.mantissa < 1ULL << 52) return sign | t.mantissa;
  const int exponent = t.exponent + 1074 + (t.mantissa >> 53 != 0 ? 1 : 0);
  if (exponent + 1 >= 0x7ff) return overflow(t.negative, mode);
  return sign | ((static_cast<std::uint64_t>(t.exponent + 1074) << 52) + t.mantissa);
}

std::uint64_t zero_sum(std::uint64_t sign_a, std::uint64_t sign_b, Rounding mode) {
  if (sign_a == sign_b) return sign_a;
  return mode == Rounding::down ? sign_bit : 0;
}

}  // namespace

std::uint64_t spu_double_madd(std::uint64_t a, std::uint64_t b, std::uint64_t c, Rounding mode) {
  if (is_nan(a) || is_nan(b) || is_nan(c)) return default_nan;
  const std::uint64_t product_sign = sign_of(a) ^ sign_of(b);
  if (is_infinite(a) || is_infinite(b)) {
    if (is_zero(a) || is_zero(b)) return default_nan;
    return is_infinite(c) && sign_of(c) != product_sign ? default_nan : product_sign | infinity;
  }
  if (is_infinite(c)) return c;
  ExactSum sum;
  sum.add_product(double_term(a), double_term(b));
  sum.add(double_term(c));
  if (sum.is_zero()) return zero_sum(product_sign, sign_of(c), mode);
  return double_from(sum, mode);
}

std::uint64_t spu_double_add(std::uint64_t a, std::uint64_t b, Rounding mode) {
  return spu_double_madd(a, 0x3ff0000000000000, b, mode);
}

std::uint64_t spu_double_multiply(std::uint64_t a, std::uint64_t b, Rounding mode) {
  // A zero of the product's own sign is neutral.
  return spu_double_madd(a, b, sign_of(a) ^ sign_of(b), mode);
}

}  // namespace reference
