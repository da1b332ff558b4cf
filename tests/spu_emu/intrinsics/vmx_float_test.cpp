#include <vmx2spu.h>

#include "check.h"
#include "exact.h"
#include "operations.h"

#include <cmath>

namespace {

using namespace reference;

using V = vec_float4;

bool is_zero(u64 word) {
  return (word & 0x7f800000) == 0;
}

double value_of(u64 word) {
  if (is_zero(word)) return 0;
  const int exponent = static_cast<int>(word >> 23 & 255) - 150;
  const double size = std::ldexp(static_cast<double>((word & 0x7fffff) | 0x800000), exponent);
  return word >> 31 != 0 ? -size : size;
}

// Exact for the integers of rounding, all below 2^24.
u64 word_of(double v) {
  const float f = static_cast<float>(v);
  std::uint32_t w = 0;
  std::memcpy(&w, &f, 4);
  return v == 0 ? 0 : w;
}

// An SPU rounds up what is less than 2^-24 by adding too little to reach 1.
template <double (*Round)(double)>
u64 rounded(u64 word) {
  const u64 size = word & 0x7fffffff;
  if (size < 0x33800000) return 0;
  return size >= 0x4b000000 ? word : word_of(Round(value_of(word)));
}

double to_even(double v) {
  const double down = std::floor(v);
  const double rest = v - down;
  if (rest != 0.5) return rest < 0.5 ? down : down + 1;
  return std::fmod(down, 2) == 0 ? down : down + 1;
}

TEST(VmxFloat, RoundsToIntegersInAllDirections) {
  const spu_emu::SpuFloatMode mode;
  check<V>(
      "vec_floor", [](V a) { return vec_floor(a); }, lanewise<4>(rounded<std::floor>));
  check<V>(
      "vec_ceil", [](V a) { return vec_ceil(a); }, lanewise<4>(rounded<std::ceil>));
  check<V>(
      "vec_trunc", [](V a) { return vec_trunc(a); }, lanewise<4>(rounded<std::trunc>));
  check<V>(
      "vec_round", [](V a) { return vec_round(a); }, lanewise<4>(rounded<to_even>));
  for (float f = -4; f <= 4; f += 0.25F) {
    EXPECT_EQ(vec_floor(spu_splats(f))[0], std::floor(f));
    EXPECT_EQ(vec_ceil(spu_splats(f))[0], std::ceil(f));
    EXPECT_EQ(vec_trunc(spu_splats(f))[0], std::trunc(f));
    EXPECT_EQ(vec_round(spu_splats(f))[0], to_even(f));
  }
}

TEST(VmxFloat, TruncatesTheSumsByWhichItRounds) {
  const spu_emu::SpuFloatMode mode;
  EXPECT_EQ(image(vec_ceil((V)spu_splats(0x337fffffU))), image(V{}));
  EXPECT_EQ(image(vec_ceil((V)spu_splats(0x33800000U))), image(spu_splats(1.0F)));
  EXPECT_EQ(image(vec_floor((V)spu_splats(0xb37fffffU))), image(V{}));
  EXPECT_EQ(image(vec_floor((V)spu_splats(0xb3800000U))), image(spu_splats(-1.0F)));
  EXPECT_EQ(image(vec_round((V)spu_splats(0x3f000001U))), image(V{}));
  EXPECT_EQ(image(vec_round((V)spu_splats(0x3f000002U))), image(spu_splats(1.0F)));
  EXPECT_EQ(image(vec_round((V)spu_splats(0xbf000001U))), image(V{}));
  EXPECT_EQ(image(vec_round((V)spu_splats(0xbf000002U))), image(spu_splats(-1.0F)));
}

// Sums and products as an SPU has them, on words.
u64 multiply_add(u64 a, u64 b, u64 c) {
  return spu_madd(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                  static_cast<std::uint32_t>(c));
}
constexpr u64 one = 0x3f800000;
u64 from_integer(s64 n) {
  reference::ExactSum sum;
  sum.add({n < 0, static_cast<u64>(n < 0 ? -n : n), 0});
  return spu_float_from(sum);
}
s64 to_word(double v) {
  return v >= 2147483648.0 ? INT32_MAX : v < -2147483648.0 ? INT32_MIN : static_cast<s64>(v);
}

u64 power_of_two_estimate(u64 a) {
  const u64 sum = a >> 31 != 0 ? multiply_add(one, a, 0) : multiply_add(one, a, 0x3f7fffff);
  const s64 next = to_word(value_of(sum));
  const u64 below = multiply_add(one, from_integer(next), a ^ 0x80000000);
  const u64 slope = multiply_add(0x3e2fb0cc, below, 0xbf2bec33);
  const u64 power = static_cast<u64>(next + 127) << 23 & 0xffffffff;
  return multiply_add(multiply_add(slope, below, one), power, 0);
}

u64 logarithm_estimate(u64 a) {
  const s64 exponent = static_cast<s64>(a >> 23 & 255) - 127;
  const u64 fraction = (a & 0x807fffff) | one;
  const u64 offset = multiply_add(one, from_integer(exponent), 0xbfd70068);
  return multiply_add(multiply_add(0xbeae00d1, fraction, 0x4001404e), fraction, offset);
}

TEST(VmxFloat, EstimatesPowersAndLogarithmsByTheParabolasOfTheSdk) {
  const spu_emu::SpuFloatMode mode;
  check<V>(
      "vec_expte", [](V a) { return vec_expte(a); }, lanewise<4>(power_of_two_estimate));
  check<V>(
      "vec_loge", [](V a) { return vec_loge(a); }, lanewise<4>(logarithm_estimate));
}

TEST(VmxFloat, EstimatesPowersOfTwo) {
  const spu_emu::SpuFloatMode mode;
  for (int n = -126; n <= 128; ++n)
    EXPECT_EQ(image(vec_expte(spu_splats(static_cast<float>(n)))),
              image(spu_splats(static_cast<unsigned>(n + 127) << 23)));
  for (float f = -126; f < 127; f += 0.0625F)
    EXPECT_NEAR(vec_expte(spu_splats(f))[0] / std::exp2(static_cast<double>(f)), 1, 0.004) << f;
  EXPECT_EQ(image(vec_expte(spu_splats(-127.0F))), image(V{}));
  EXPECT_EQ(image(vec_expte(spu_splats(-128.0F))), image(spu_splats(0xff800000U)));
}

TEST(VmxFloat, EstimatesLogarithms) {
  const spu_emu::SpuFloatMode mode;
  for (unsigned exponent = 1; exponent < 256; ++exponent)
    EXPECT_NEAR(vec_loge((V)spu_splats(exponent << 23))[0], static_cast<float>(exponent) - 127, 1e-4);
  for (float f = 0.01F; f < 1000; f *= 1.01F)
    EXPECT_NEAR(vec_loge(spu_splats(f))[0], std::log2(static_cast<double>(f)), 0.01) << f;
  EXPECT_NEAR(vec_loge(V{})[0], -127, 1e-4);
}

TEST(VmxFloat, MakesAbsoluteAndPicksByCompareAndSelect) {
  const spu_emu::SpuFloatMode mode;
  const auto greater = [](u64 a, u64 b) { return value_of(a) > value_of(b); };
  check<V>(
      "vec_abs", [](V a) { return vec_abs(a); }, lanewise<4>([](u64 a) { return a & 0x7fffffff; }));
  check<V, V>(
      "vec_max", [](V a, V b) { return vec_max(a, b); },
      lanewise<4>([=](u64 a, u64 b) { return greater(a, b) ? a : b; }));
  check<V, V>(
      "vec_min", [](V a, V b) { return vec_min(a, b); },
      lanewise<4>([=](u64 a, u64 b) { return greater(a, b) ? b : a; }));
}

// What forwards to a function with a reference of its own.
TEST(VmxFloat, ForwardsArithmeticAndConversions) {
  const spu_emu::SpuFloatMode mode;
  const V a = {1.5F, -2.25F, 1e10F, 3};
  const V b = {0.1F, 7, -3, 0.333F};
  const V c = {-4, 0.5F, 11, 1e-3F};
  EXPECT_EQ(image(vec_add(a, b)), image(spu_add(a, b)));
  EXPECT_EQ(image(vec_sub(a, b)), image(spu_sub(a, b)));
  EXPECT_EQ(image(vec_madd(a, b, c)), image(spu_madd(a, b, c)));
  EXPECT_EQ(image(vec_nmsub(a, b, c)), image(spu_nmsub(a, b, c)));
  EXPECT_EQ(image(vec_re(a)), image(spu_re(a)));
  EXPECT_EQ(image(vec_rsqrte(a)), image(spu_rsqrte(a)));
  EXPECT_EQ(image(vec_ctf(vec_int4{-3, 5, 7, 9}, 1)), image(V{-1.5F, 2.5F, 3.5F, 4.5F}));
  EXPECT_EQ(image(vec_ctf(vec_uint4{3, 5, 7, 9}, 1)), image(V{1.5F, 2.5F, 3.5F, 4.5F}));
  EXPECT_EQ(image(vec_cts(a, 1)), image(vec_int4{3, -4, INT32_MAX, 6}));
  EXPECT_EQ(image(vec_ctu(a, 1)), image(vec_uint4{3, 0, UINT32_MAX, 6}));
}

}  // namespace
