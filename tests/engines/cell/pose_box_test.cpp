/// @file
/// Boxes made from poses (F3): every rounding goes up, and no further than it must.
#define SPU_EMU_NO_VECTOR_KEYWORD
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <vector>

#include "contract/random.h"
#include "engines/cell/spu/resident/pose_box.h"
#include "spu_emu/intrinsics/float_mode.h"

namespace cellsweep::cell {
namespace {

using contract::Random;
using Binary = vec_float4 (*)(vec_float4, vec_float4);

float on_spu(Binary operation, float a, float b) {
  const spu_emu::SpuFloatMode mode;
  return spu_extract(operation(spu_splats(a), spu_splats(b)), 2);
}

/// Of any size up to 2^±`exponent`, often with few digits, so that exact results are not rare.
float random_float(Random& random, int exponent) {
  const float digits = random.one_in(2) ? static_cast<float>(random.whole(1, 9)) : 1 + random.unit();
  return std::ldexp(digits, random.whole(-exponent, exponent));
}

/// The least float that is not below sum + rest, |rest| being less than sum's last digit.
float least_float_above(double sum, double rest) {
  auto bound = static_cast<float>(sum);
  if (bound < sum || (bound == sum && rest > 0)) bound = std::nextafterf(bound, INFINITY);
  const float below = std::nextafterf(bound, -INFINITY);
  return below > sum || (below == sum && rest <= 0) ? below : bound;
}

TEST(ResidentRounding, AProductIsTheLeastFloatThatIsNotBelow) {
  Random random(1);
  for (int round = 0; round < 200'000; ++round) {
    const float a = random_float(random, 30);
    const float b = random_float(random, 30);
    ASSERT_EQ(on_spu(product_up, a, b), least_float_above(double{a} * double{b}, 0)) << a << " * " << b;
  }
}

TEST(ResidentRounding, ATinyProductIsNotBelowEither) {
  Random random(2);
  for (int round = 0; round < 100'000; ++round) {
    const float a = std::ldexp(1 + random.unit(), random.whole(-126, 0));
    const float b = std::ldexp(1 + random.unit(), random.whole(-126, 0));
    const float up = on_spu(product_up, a, b);
    ASSERT_GE(double{up}, double{a} * double{b}) << a << " * " << b;
    ASSERT_TRUE(std::isnormal(up));
  }
  EXPECT_EQ(on_spu(product_up, 0, 5), 0.0F);
}

TEST(ResidentRounding, ASumIsTheLeastFloatThatIsNotBelow) {
  Random random(3);
  for (int round = 0; round < 200'000; ++round) {
    const float a = random_float(random, 20) * (random.one_in(2) ? -1.0F : 1.0F);
    const float b = random.one_in(50) ? -a : random_float(random, 20) * (random.one_in(2) ? -1.0F : 1.0F);
    const double sum = double{a} + double{b};
    const double part = sum - double{a};
    const double rest = (double{a} - (sum - part)) + (double{b} - part);
    const float up = on_spu(sum_up, a, b);
    ASSERT_EQ(up, least_float_above(sum, rest)) << a << " + " << b;
    ASSERT_FALSE(up == 0 && std::signbit(up)) << a << " + " << b;
    const float expected = sum < 0 ? least_float_above(-sum, -rest) : least_float_above(sum, rest);
    ASSERT_EQ(on_spu(magnitude_of_sum_up, a, b), expected) << a << " + " << b;
  }
}

TEST(ResidentRounding, ASumTooSmallForANormalFloatIsTheLeastOne) {
  const float least = FLT_MIN;
  EXPECT_EQ(on_spu(sum_up, 1.5F * least, -least), least);
  EXPECT_EQ(on_spu(sum_up, -1.5F * least, least), 0.0F);
  EXPECT_EQ(on_spu(sum_up, 3, least), std::nextafterf(3, 4));
  EXPECT_EQ(on_spu(sum_up, -3, least), std::nextafterf(-3, 0)) << "the least float above is above -3";
}

TEST(ResidentRounding, AQuotientIsNotBelowAndTwoStepsAboveAtMost) {
  Random random(4);
  for (int round = 0; round < 200'000; ++round) {
    const float a = random_float(random, 60);
    const float b = random_float(random, 17);
    const float up = on_spu(quotient_up, a, b);
    const double quotient = double{a} / double{b};
    ASSERT_GE(std::fma(double{up}, double{b}, -double{a}), 0) << a << " / " << b;
    ASSERT_LE(std::nextafterf(std::nextafterf(up, 0), 0), quotient) << a << " / " << b;
    ASSERT_TRUE(b != 1 || up == a) << a;
  }
  EXPECT_EQ(on_spu(quotient_up, 0, 3), 0.0F);
  EXPECT_GE(on_spu(quotient_up, FLT_MIN, 0x1p20F), 0.0F);
  EXPECT_TRUE(std::isnormal(on_spu(quotient_up, FLT_MIN, 0x1p20F)));
}

struct Interval {
  float low = 0;
  float high = 0;
};

Interval enclosed(const PoseBlock& block, unsigned axis, int lane) {
  const spu_emu::SpuFloatMode mode;
  PoseVectors pose{};
  std::memcpy(&pose, &block, sizeof pose);
  const IntervalVectors four = enclose(pose, axis);
  return {spu_extract(four.low, lane), spu_extract(four.high, lane)};
}

/// How far a turned box reaches along an axis: the rotation matrix by the book, in long doubles.
long double true_reach(const PoseBlock& block, unsigned axis, int lane) {
  const long double x = block.orientation[0][lane];
  const long double y = block.orientation[1][lane];
  const long double z = block.orientation[2][lane];
  const long double w = block.orientation[3][lane];
  const long double n = x * x + y * y + z * z + w * w;
  const long double rows[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                                  {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                                  {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
  long double reach = 0;
  for (int k = 0; k < 3; ++k) reach += std::fabs(rows[axis][k]) * block.half_extents[k][lane];
  return reach / n;
}

PoseBlock random_poses(Random& random, int exponent) {
  PoseBlock block{};
  for (int lane = 0; lane < 4; ++lane) {
    const float scale = std::ldexp(1.0F, random.whole(-9, 9));
    for (int k = 0; k < 4; ++k) block.orientation[k][lane] = scale * random.between(-1, 1);
    if (random.one_in(4)) block.orientation[random.whole(0, 2)][lane] *= 1e-30F;
    block.orientation[3][lane] += scale;
    for (int k = 0; k < 3; ++k) {
      block.half_extents[k][lane] = random.one_in(8) ? 0 : random_float(random, exponent);
      block.centre[k][lane] = random_float(random, exponent) * (random.one_in(2) ? -1.0F : 1.0F);
    }
  }
  return block;
}

TEST(ResidentPoseBox, TheBoxEnclosesTheTurnedOneAndIsLittleWider) {
  Random random(5);
  for (int round = 0; round < 40'000; ++round) {
    const PoseBlock block = random_poses(random, round % 2 == 0 ? 3 : 40);
    for (unsigned axis = 0; axis < 3; ++axis) {
      const int lane = round % 4;
      const Interval box = enclosed(block, axis, lane);
      const long double centre = block.centre[axis][lane];
      const long double reach = true_reach(block, axis, lane);
      const long double rounding = 0x1p-62L * (std::fabs(centre) + reach);
      ASSERT_LE(box.low, centre - reach + rounding) << "round " << round;
      ASSERT_GE(box.high, centre + reach - rounding) << "round " << round;
      const long double extent =
          block.half_extents[0][lane] + block.half_extents[1][lane] + block.half_extents[2][lane];
      const long double slack = 0x1p-23L * (std::fabs(centre) + 16 * extent) + 0x1p-90L;
      ASSERT_LE(box.high - (centre + reach), slack) << "round " << round;
      ASSERT_LE(centre - reach - box.low, slack) << "round " << round;
    }
  }
}

/// How much wider than it must be the box is on an axis, in parts of what it may be: the bound that
/// cellsweep/cell.h states.
double width_of_bound(const PoseBlock& block, unsigned axis) {
  const Interval box = enclosed(block, axis, 0);
  const long double centre = block.centre[axis][0];
  const long double reach = true_reach(block, axis, 0);
  const long double extent = block.half_extents[0][0] + block.half_extents[1][0] + block.half_extents[2][0];
  const long double wider = std::max(box.high - (centre + reach), centre - reach - box.low);
  return static_cast<double>(wider / (0x1p-23L * std::fabs(centre) + 0x1p-19L * extent + 0x1p-90L));
}

/// A pose a little different, or of which two numbers are alike: there differences of products vanish.
PoseBlock varied(PoseBlock block, Random& random) {
  float& number = random.one_in(2)
                      ? block.orientation[random.whole(0, 3)][0]
                      : (random.one_in(4) ? block.centre : block.half_extents)[random.whole(0, 2)][0];
  switch (random.whole(0, 3)) {
    case 0:
      number *= 1 + random.between(-1e-6F, 1e-6F);
      break;
    case 1:
      number = std::nextafterf(number, INFINITY);
      break;
    case 2:
      block.orientation[random.whole(0, 3)][0] = block.orientation[random.whole(0, 3)][0];
      break;
    default:
      number *= random.between(0.25F, 4);
  }
  return block;
}

bool may_be_given(const PoseBlock& block) {
  float square = 0;
  for (const auto& x : block.orientation) square += x[0] * x[0];
  return square >= 0x1p-18F && square <= 0x1p18F;
}

// A box that is long on one axis is wider by a part of that length on all: it turns by as much as a float
// step.
TEST(ResidentPoseBox, NoSearchFindsOneThatIsWiderThanIsStated) {
  double widest = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    PoseBlock worst = random_poses(random, 12);
    const unsigned axis = static_cast<unsigned>(seed) % 3;
    double most = 0;
    for (int step = 0; step < 300; ++step) {
      const PoseBlock next = varied(worst, random);
      if (!may_be_given(next)) continue;
      const double width = width_of_bound(next, axis);
      if (width < most) continue;
      worst = next;
      most = width;
    }
    widest = std::max(widest, most);
    ASSERT_LE(most, 1) << "seed " << seed;
  }
  EXPECT_GT(widest, 0.25) << "the bound that is stated is not far from the true one";
}

TEST(ResidentPoseBox, ABoxThatIsNotTurnedIsCentrePlusAndMinusItsHalfExtents) {
  Random random(6);
  for (int round = 0; round < 20'000; ++round) {
    PoseBlock block = random_poses(random, 4);
    for (int k = 0; k < 4; ++k) {
      for (float& x : block.orientation[k]) x = k == 3 ? 1.0F : 0.0F;
    }
    const unsigned axis = static_cast<unsigned>(round) % 3;
    const double centre = block.centre[axis][1];
    const double half = block.half_extents[axis][1];
    const Interval box = enclosed(block, axis, 1);
    ASSERT_EQ(box.high, least_float_above(centre + half, 0));
    ASSERT_EQ(box.low, -least_float_above(half - centre, 0));
    ASSERT_FALSE(box.low == 0 && std::signbit(box.low));
  }
}

}  // namespace
}  // namespace cellsweep::cell
