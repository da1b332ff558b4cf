// Single-precision instructions against exact arithmetic, their flags too.
#include <algorithm>

#include "../../intrinsics/exact.h"
#include "reference_check.h"

namespace spu_emu::isa {
namespace {

using namespace reference;

constexpr u64 kSingleSign = 0x80000000;
constexpr u64 kOne = 0x3f800000;

u64 exponent_of(u64 word) {
  return word >> 23 & 255;
}

ExactSum exact_madd(u64 a, u64 b, u64 c) {
  ExactSum sum;
  sum.add_product(spu_float_term(static_cast<std::uint32_t>(a)),
                  spu_float_term(static_cast<std::uint32_t>(b)));
  sum.add(spu_float_term(static_cast<std::uint32_t>(c)));
  return sum;
}

u64 madd(u64 a, u64 b, u64 c) {
  return spu_float_from(exact_madd(a, b, c));
}

TEST(SingleInstructions, RoundTowardZeroForEveryExponent) {
  ReferenceCheck spu;
  spu.check("fa", of_ab(lanewise<4>([](u64 a, u64 b) { return madd(a, kOne, b); })));
  spu.check("fs", of_ab(lanewise<4>([](u64 a, u64 b) { return madd(b, kOne | kSingleSign, a); })));
  spu.check("fm", of_ab(lanewise<4>([](u64 a, u64 b) { return madd(a, b, 0); })));
  spu.check("fma", of_abt(lanewise<4>([](u64 a, u64 b, u64 c) { return madd(a, b, c); })));
  spu.check("fms", of_abt(lanewise<4>([](u64 a, u64 b, u64 c) { return madd(a, b, c ^ kSingleSign); })));
  spu.check("fnms", of_abt(lanewise<4>([](u64 a, u64 b, u64 c) { return madd(a ^ kSingleSign, b, c); })));
}

bool is_unusual(u64 word) {
  return exponent_of(word) == 255 || (exponent_of(word) == 0 && (word & 0x7fffff) != 0);
}

/// Overflow 4, underflow 2, different from IEEE 1; of a * b + c when only `operands` of them are operands.
u64 flags_of(u64 a, u64 b, u64 c, bool unusual) {
  const ExactSum sum = exact_madd(a, b, c);
  bool overflow = false;
  bool underflow = false;
  if (!sum.is_zero()) {
    const int exponent = sum.rounded(24, -100000, Rounding::toward_zero).exponent + 150;
    overflow = exponent > 255;
    underflow = exponent <= 0;
  }
  const bool different = unusual || underflow || exponent_of(spu_float_from(sum)) == 255;
  return (overflow ? 4 : 0) | (underflow ? 2 : 0) | (different ? 1 : 0);
}

TEST(SingleInstructions, CollectTheirFlagsInTheFpscr) {
  ReferenceCheck spu;
  const auto unusual = [](auto... words) { return (is_unusual(words) || ...); };
  const auto check = [&](const char* name, const Reference& reference) { spu.check(name, reference, true); };
  check("fa", of_ab(lanewise<4>([&](u64 a, u64 b) { return flags_of(a, kOne, b, unusual(a, b)); })));
  check("fs",
        of_ab(lanewise<4>([&](u64 a, u64 b) { return flags_of(b, kOne | kSingleSign, a, unusual(a, b)); })));
  check("fm", of_ab(lanewise<4>([&](u64 a, u64 b) { return flags_of(a, b, 0, unusual(a, b)); })));
  check("fma", of_abt(lanewise<4>([&](u64 a, u64 b, u64 c) { return flags_of(a, b, c, unusual(a, b, c)); })));
  check("fms", of_abt(lanewise<4>(
                   [&](u64 a, u64 b, u64 c) { return flags_of(a, b, c ^ kSingleSign, unusual(a, b, c)); })));
  check("fnms", of_abt(lanewise<4>(
                    [&](u64 a, u64 b, u64 c) { return flags_of(a ^ kSingleSign, b, c, unusual(a, b, c)); })));
}

TEST(SingleInstructions, SetTheDivisionByZeroFlagOfEachSlotOfAnEstimate) {
  ReferenceCheck spu;
  const Reference flags = of_a([](const Register& a) {
    u64 bits = 0;
    for (int i = 0; i < 4; ++i) bits |= exponent_of(lane<4>(a, i)) == 0 ? 0x800U >> i : 0U;
    Register r{};
    put<4>(r, 3, bits);
    return r;
  });
  spu.check("frest", flags, true);
  spu.check("frsqest", flags, true);
}

s64 key(u64 word) {
  const auto magnitude = static_cast<s64>(word & 0x7fffffff);
  return magnitude < 0x00800000 ? 0 : (word & kSingleSign) != 0 ? -magnitude : magnitude;
}

TEST(SingleInstructions, CompareBySignAndMagnitude) {
  ReferenceCheck spu;
  spu.check("fceq", of_ab(lanewise<4>([](u64 a, u64 b) { return all_ones(key(a) == key(b)); })));
  spu.check("fcgt", of_ab(lanewise<4>([](u64 a, u64 b) { return all_ones(key(a) > key(b)); })));
  spu.check("fcmeq", of_ab(lanewise<4>([](u64 a, u64 b) {
              return all_ones(key(a & ~kSingleSign) == key(b & ~kSingleSign));
            })));
  spu.check("fcmgt", of_ab(lanewise<4>([](u64 a, u64 b) {
              return all_ones(key(a & ~kSingleSign) > key(b & ~kSingleSign));
            })));
}

/// base - step * y with y the argument's low 19 fraction bits, truncated to 24 significant bits.
u64 interpolated(u64 argument, u64 line) {
  if (exponent_of(line) == 0) return 0;
  const u64 base = (line >> 10 & 0x1fff) + 0x2000;
  const u64 sum = (base << 19) - (line & 0x3ff) * (argument & 0x7ffff);
  if (sum >> 32 != 0) return (line & 0xff800000) | (sum >> 9 & 0x7fffff);
  return exponent_of(line) == 1 ? 0 : ((line & 0xff800000) - 0x00800000) | (sum >> 8 & 0x7fffff);
}

TEST(SingleInstructions, InterpolateALine) {
  ReferenceCheck().check("fi", of_ab(lanewise<4>(interpolated)));
}

u64 scaled_float(s64 integer, int scale) {
  ExactSum sum;
  sum.add({integer < 0, static_cast<u64>(integer < 0 ? -integer : integer), -scale});
  return spu_float_from(sum);
}

/// The float times 2^scale, truncated and cut down to [least, most].
s64 scaled_integer(u64 word, int scale, s64 least, s64 most) {
  const auto exponent = static_cast<int>(exponent_of(word));
  if (exponent == 0) return 0;
  const bool negative = (word & kSingleSign) != 0;
  const int shift = exponent - 150 + scale;
  const s64 mantissa = static_cast<s64>((word & 0x7fffff) | 0x800000);
  if (shift > 32) return negative ? least : most;
  const s64 magnitude = shift < -32 ? 0 : shift < 0 ? mantissa >> -shift : mantissa << shift;
  return std::clamp(negative ? -magnitude : magnitude, least, most);
}

TEST(SingleInstructions, ConvertToAndFromScaledIntegers) {
  ReferenceCheck spu;
  const auto with_scale = [](auto reference) {
    return [reference](const Operands& o) {
      return build<4>([&](int i) { return static_cast<u64>(reference(o.a, i, o.immediate)); });
    };
  };
  spu.check("csflt", with_scale([](const Register& a, int i, int n) {
              return scaled_float(signed_lane<4>(a, i), n);
            }));
  spu.check("cuflt", with_scale([](const Register& a, int i, int n) {
              return scaled_float(static_cast<s64>(lane<4>(a, i)), n);
            }));
  spu.check("cflts", with_scale([](const Register& a, int i, int n) {
              return scaled_integer(lane<4>(a, i), n, INT32_MIN, INT32_MAX);
            }));
  spu.check("cfltu", with_scale([](const Register& a, int i, int n) {
              return scaled_integer(lane<4>(a, i), n, 0, UINT32_MAX);
            }));
}

}  // namespace
}  // namespace spu_emu::isa
