#include "check.h"
#include "operations.h"

#include <cmath>

namespace {

using namespace reference;

using V = vec_float4;

u64 exponent_of(u64 word) {
  return word >> 23 & 255;
}

double value_of(u64 word) {
  const double size = std::ldexp(static_cast<double>((word & 0x7fffff) | 0x800000),
                                 static_cast<int>(exponent_of(word)) - 150);
  return exponent_of(word) == 0 ? 0 : word >> 31 != 0 ? -size : size;
}

// The line's exponent and sign are exact; its fraction is checked through what it interpolates to.
TEST(Estimate, HasTheExponentAndSignOfTheReciprocal) {
  const auto head = [](V v) { return spu_and((vec_uint4)v, 0xff800000U); };
  check<V>(
      "spu_frest", [&](V a) { return head(spu_frest(a)); }, lanewise<4>([](u64 a) {
        const u64 e = exponent_of(a);
        return (a & 0x80000000) | (e == 0 ? 255 : e > 253 ? 0 : 253 - e) << 23;
      }));
  check<V>(
      "spu_frsqest", [&](V a) { return head(spu_frsqest(a)); }, lanewise<4>([](u64 a) {
        const u64 e = exponent_of(a);
        return (e == 0 ? 255 : 190 - (e + 1) / 2) << 23;
      }));
}

// base - step * y with y the argument's low 19 fraction bits, truncated to 24 significant bits.
u64 interpolated(u64 argument, u64 line) {
  const u64 exponent = exponent_of(line);
  if (exponent == 0) return 0;
  const u64 base = (line >> 10 & 0x1fff) + 0x2000;                       // units of 2^-13
  const u64 sum = (base << 19) - (line & 0x3ff) * (argument & 0x7ffff);  // units of 2^-32
  if (sum >> 32 != 0) return (line & 0xff800000) | (sum >> 9 & 0x7fffff);
  return exponent == 1 ? 0 : ((line & 0xff800000) - 0x00800000) | (sum >> 8 & 0x7fffff);
}

TEST(Estimate, InterpolatesAnyLineExactlyAndTruncates) {
  check<qword, qword>(
      "si_fi", [](qword a, qword b) { return si_fi(a, b); }, lanewise<4>(interpolated));
}

bool in_estimates_range(u64 word) {
  return exponent_of(word) >= 1 && exponent_of(word) <= 252;
}

bool within_12_bits(double estimate, double exact) {
  return std::abs(estimate / exact - 1) < 0x1p-12;
}

TEST(Estimate, OfReciprocalsIsRightToTwelveBits) {
  check<V>(
      "spu_re", [](V a) { return spu_re(a); }, [](const Register& a) { return a; },
      [](const Value& result, const Value& expected, const Value*) {
        for (int i = 0; i < 4; ++i) {
          const u64 a = lane<4>(expected.image, i);
          if (in_estimates_range(a) && !within_12_bits(value_of(lane<4>(result.image, i)), 1 / value_of(a)))
            return false;
        }
        return true;
      });
}

TEST(Estimate, OfReciprocalRootsIsRightToTwelveBitsWhateverTheSign) {
  check<V>(
      "spu_rsqrte", [](V a) { return spu_rsqrte(a); }, [](const Register& a) { return a; },
      [](const Value& result, const Value& expected, const Value*) {
        for (int i = 0; i < 4; ++i) {
          const u64 a = lane<4>(expected.image, i);
          const double root = std::sqrt(std::abs(value_of(a)));
          if (exponent_of(a) != 0 && !within_12_bits(value_of(lane<4>(result.image, i)), 1 / root))
            return false;
        }
        return true;
      });
}

// Every fraction that selects a table entry, at both ends and in the middle of its segment.
TEST(Estimate, IsRightInEverySegmentOfItsTables) {
  for (unsigned int head = 0x3f000000; head < 0x40000000; head += 1 << 18) {
    for (const unsigned int low : {0U, 1U, 0x1ffffU, 0x3fffeU, 0x3ffffU}) {
      const V a = (V)spu_splats(head | low);
      const double x = value_of(head | low);
      EXPECT_TRUE(within_12_bits(value_of(lane<4>(image(spu_re(a)), 0)), 1 / x)) << x;
      EXPECT_TRUE(within_12_bits(value_of(lane<4>(image(spu_rsqrte(a)), 0)), 1 / std::sqrt(x))) << x;
    }
  }
}

}  // namespace
