// Functions whose results are exact, against scalar ones.
#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <cstring>
#include <random>

#include "simdmath/evaluator.h"

namespace {

using namespace simdmath_test;

Result call(const std::string& name, Words x, Words y = {}, Words z = {}) {
  return evaluate_on_host(number_of(name), {Call{x, y, z}})[0];
}
std::uint32_t bits(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  return b;
}
Words floats(float a, float b, float c, float d) {
  return {bits(a), bits(b), bits(c), bits(d)};
}
Words longs(std::int64_t a, std::int64_t b) {
  const auto x = static_cast<std::uint64_t>(a);
  const auto y = static_cast<std::uint64_t>(b);
  return {static_cast<std::uint32_t>(x >> 32U), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y >> 32U),
          static_cast<std::uint32_t>(y)};
}

TEST(SimdMath, IntegersAreDividedAsTheCompilerDividesThem) {
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i) {
    Words a;
    Words b;
    for (int lane = 0; lane < 4; ++lane) {
      a[lane] = random() >> random() % 32;
      b[lane] = random() >> random() % 32;
      if (random() % 4 == 0) a[lane] = -a[lane];
      if (random() % 4 == 0) b[lane] = -b[lane];
    }
    const Result of_unsigned = call("divu4", a, b);
    const Result of_signed = call("divi4", a, b);
    for (int lane = 0; lane < 4; ++lane) {
      const std::int64_t x = static_cast<std::int32_t>(a[lane]);
      const std::int64_t y = static_cast<std::int32_t>(b[lane]);
      ASSERT_EQ(of_unsigned[0][lane], b[lane] == 0 ? 0 : a[lane] / b[lane]) << a[lane] << " / " << b[lane];
      ASSERT_EQ(of_unsigned[1][lane], b[lane] == 0 ? a[lane] : a[lane] % b[lane]) << a[lane] << " / " << b[lane];
      ASSERT_EQ(of_signed[0][lane], static_cast<std::uint32_t>(y == 0 ? 0 : x / y)) << x << " / " << y;
      ASSERT_EQ(of_signed[1][lane], static_cast<std::uint32_t>(y == 0 ? x : x % y)) << x << " / " << y;
    }
  }
}

TEST(SimdMath, LongIntegersAreDividedAsTheCompilerDividesThem) {
  const std::int64_t values[] = {0, 1, -1, 7, -7, 1000000007, INT64_MAX, INT64_MIN, INT64_MIN + 1, 0x123456789abcdef};
  for (const std::int64_t x : values) {
    for (const std::int64_t y : values) {
      const bool overflows = x == INT64_MIN && y == -1;
      const std::int64_t quotient = y == 0 ? 0 : overflows ? x : x / y;
      const std::int64_t rest = y == 0 ? x : overflows ? 0 : x % y;
      const Result result = call("lldivi2", longs(x, 12), longs(y, 5));
      EXPECT_EQ(result[0], longs(quotient, 2)) << x << " / " << y;
      EXPECT_EQ(result[1], longs(rest, 2)) << x << " / " << y;
    }
  }
  EXPECT_EQ(call("lldivu2", longs(-1, 100), longs(10, 7))[0], longs(0x1999999999999999, 14));
  EXPECT_EQ(call("llabsi2", longs(-5, INT64_MIN))[0], longs(5, INT64_MIN));
  EXPECT_EQ(call("negatell2", longs(-5, 9))[0], longs(5, -9));
}

TEST(SimdMath, FractionAndExponentArePutTogetherAgain) {
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i) {
    Words x;
    for (auto& word : x) word = random();
    const Result parts = call("frexpf4", x);
    const Words again = call("ldexpf4", parts[0], parts[1])[0];
    for (int lane = 0; lane < 4; ++lane) {
      if ((x[lane] & 0x7f800000U) == 0) {
        ASSERT_EQ(parts[0][lane] | parts[1][lane], 0U);
        continue;
      }
      ASSERT_EQ(parts[0][lane], (x[lane] & 0x807fffffU) | 0x3f000000U);
      ASSERT_EQ(again[lane], x[lane]);
    }
  }
}

TEST(SimdMath, ScalingEndsAtTheLargestNumberAndAtZero) {
  EXPECT_EQ(call("ldexpf4", floats(1, 1, -1, 1.5F), {128, 129, 200, static_cast<std::uint32_t>(-126)})[0],
            (Words{0x7f800000, 0x7fffffff, 0xffffffff, 0x00c00000}));
  EXPECT_EQ(call("scalbnf4", floats(1, 1, -1, 0),
                 {static_cast<std::uint32_t>(-127), INT_MAX, static_cast<std::uint32_t>(INT_MIN), 5})[0],
            (Words{0, 0x7fffffff, 0, 0}));
}

TEST(SimdMath, ExponentsAreThoseOfTheNumbers) {
  EXPECT_EQ(call("ilogbf4", {bits(1), bits(-0.75F), 0x7fffffff, 0})[0],
            (Words{0, static_cast<std::uint32_t>(-1), 128, 0x80000000}));
  EXPECT_EQ(call("logbf4", {bits(8), bits(-0.75F), 0x7fffffff, 0})[0], (Words{bits(3), bits(-1), bits(128), 0xffffffff}));
}

TEST(SimdMath, TheNextNumberIsTheNeighbour) {
  EXPECT_EQ(call("nextafterf4", {bits(1), bits(1), bits(-1), 0}, floats(2, 0, 2, -3))[0],
            (Words{0x3f800001, 0x3f7fffff, 0xbf7fffff, 0x80800000}));
  EXPECT_EQ(call("nextafterf4", {0x00800000, bits(5), 0, 0x80800000}, floats(-1, 5, 1, 1))[0],
            (Words{0, bits(5), 0x00800000, 0}));
}

TEST(SimdMath, WholeNumbersBecomeIntegers) {
  EXPECT_EQ(call("irintf4", floats(2.75F, -2.75F, 3e9F, -3e9F))[0],
            (Words{2, static_cast<std::uint32_t>(-2), 0x7fffffff, 0x80000000}));
  EXPECT_EQ(call("iroundf4", floats(2.5F, -2.5F, 0.49999997F, -7))[0],
            (Words{3, static_cast<std::uint32_t>(-3), 0, static_cast<std::uint32_t>(-7)}));
  const Result longs_of = call("llroundf4", floats(2.5F, -1e18F, 1e30F, -1e30F));
  EXPECT_EQ(longs_of[0], longs(3, -999999984306749440));
  EXPECT_EQ(longs_of[1], longs(INT64_MAX, INT64_MIN));
  EXPECT_EQ(call("llrintf4", floats(2.75F, -2.75F, 0, 1e10F))[0], longs(2, -2));
}

TEST(SimdMath, QuotientsOfRemaindersHaveThreeBitsAndASign) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(-100, 100);
  for (int i = 0; i < 20000; ++i) {
    const float x = any(random);
    const float y = any(random);
    int quotient = 0;
    std::remquo(static_cast<double>(x), static_cast<double>(y), &quotient);
    const Result result = call("remquof4", floats(x, x, x, x), floats(y, y, y, y));
    const int found = static_cast<int>(result[1][0]);
    ASSERT_EQ(std::abs(found) & 7, std::abs(quotient) & 7) << x << " by " << y;
    ASSERT_TRUE(found == 0 || (found < 0) == (x / y < 0)) << x << " by " << y;
  }
}

TEST(SimdMath, ComparesSeeNoNaNOnTheSpu) {
  const Words nan_elsewhere = {0x7fc00000, 0x7f800000, 0x00000001, 0x80000000};
  const Words all = {~0U, ~0U, ~0U, ~0U};
  const Words none = {};
  EXPECT_EQ(call("isnanf4", nan_elsewhere)[0], none);
  EXPECT_EQ(call("isinff4", nan_elsewhere)[0], none);
  EXPECT_EQ(call("isfinitef4", nan_elsewhere)[0], all);
  EXPECT_EQ(call("isnormalf4", nan_elsewhere)[0], (Words{~0U, ~0U, 0, 0}));
  EXPECT_EQ(call("is0denormf4", nan_elsewhere)[0], (Words{0, 0, ~0U, ~0U}));
  EXPECT_EQ(call("signbitf4", nan_elsewhere)[0], (Words{0, 0, 0, ~0U}));
  EXPECT_EQ(call("fpclassifyf4", nan_elsewhere)[0], (Words{FP_NORMAL, FP_NORMAL, FP_SUBNORMAL, FP_ZERO}));
  EXPECT_EQ(call("isgreaterf4", nan_elsewhere, floats(1, 1, 1, 1))[0], (Words{~0U, ~0U, 0, 0}));
  EXPECT_EQ(call("islessf4", floats(1, 2, 3, 4), floats(2, 2, 2, 5))[0], (Words{~0U, 0, 0, ~0U}));
  EXPECT_EQ(call("islessequalf4", floats(1, 2, 3, 4), floats(2, 2, 2, 5))[0], (Words{~0U, ~0U, 0, ~0U}));
  EXPECT_EQ(call("isgreaterequalf4", floats(1, 2, 3, 4), floats(2, 2, 2, 5))[0], (Words{0, ~0U, ~0U, 0}));
  EXPECT_EQ(call("islessgreaterf4", floats(1, 2, 3, 4), floats(2, 2, 2, 5))[0], (Words{~0U, 0, ~0U, ~0U}));
  EXPECT_EQ(call("isequalf4", floats(1, 2, 3, 4), floats(2, 2, 2, 5))[0], (Words{0, ~0U, 0, 0}));
  EXPECT_EQ(call("isunorderedf4", nan_elsewhere, nan_elsewhere)[0], none);
}

TEST(SimdMath, FastFunctionsAreRightToTheLastBitOrTwo) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(0.5F, 1000);
  for (int i = 0; i < 20000; ++i) {
    const float x = any(random);
    const float y = any(random);
    const auto near = [&](const char* name, double exact) {
      const Words result = call(name, floats(x, x, x, x), floats(y, y, y, y))[0];
      float value;
      std::memcpy(&value, result.data(), sizeof value);
      ASSERT_NEAR(value, exact, std::fabs(exact) * 0x1p-22) << name << " of " << x << ", " << y;
    };
    near("divf4_fast", static_cast<double>(x) / y);
    near("recipf4_fast", 1.0 / x);
    near("sqrtf4_fast", std::sqrt(static_cast<double>(x)));
    near("floorf4_fast", std::floor(x));
    near("ceilf4_fast", std::ceil(x));
    ASSERT_EQ(call("fmodf4_fast", floats(x, x, x, x), floats(y, y, y, y))[0][0], bits(std::fmod(x, y))) << x << ", " << y;
  }
}

TEST(SimdMath, MagnitudesOfIntegersWrapAround) {
  EXPECT_EQ(call("absi4", {1, static_cast<std::uint32_t>(-1), 0x80000000, 0})[0], (Words{1, 1, 0x80000000, 0}));
  EXPECT_EQ(call("negatei4", {1, static_cast<std::uint32_t>(-1), 0x80000000, 0})[0],
            (Words{static_cast<std::uint32_t>(-1), 1, 0x80000000, 0}));
}

}  // namespace
