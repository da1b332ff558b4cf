#include "world/arithmetic.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>

#include "world/random.h"

namespace cellsweep {
namespace {

TEST(Arithmetic, CubeRootsOfWholeCubesAreWhole) {
  for (const double root : {1.0, 2.0, 3.0, 7.0, 10.0, 16.0, 100.0, 1625.0}) {
    EXPECT_NEAR(cube_root(root * root * root), root, root * 4e-16);
  }
}

TEST(Arithmetic, CubeRootsAgreeWithTheMathLibraryOverTwelveOrdersOfMagnitude) {
  for (double x = 1; x < 1e12; x *= 1.07) EXPECT_NEAR(cube_root(x), std::cbrt(x), std::cbrt(x) * 1e-15) << x;
}

TEST(Arithmetic, PowersAgreeWithTheMathLibraryToNineDigits) {
  EXPECT_EQ(power(100, 0.0), 1.0);
  EXPECT_EQ(power(100, 0.5), 10.0);
  for (double u = 0; u < 1; u += 0.00137)
    EXPECT_NEAR(power(100, u), std::pow(100, u), std::pow(100, u) * 2e-9) << u;
}

TEST(Random, GivesThePublishedNumbersOfSplitmix64) {
  Random random(1234567);
  const std::array<std::uint64_t, 5> published = {6457827717110365317U, 3203168211198807973U,
                                                  9817491932198370423U, 4593380528125082431U,
                                                  16408922859458223821U};
  for (const std::uint64_t number : published) EXPECT_EQ(random.next(), number);
}

TEST(Random, UnitsLieInTheirHalfOpenIntervals) {
  Random random(5);
  double sum = 0;
  for (int i = 0; i < 10000; ++i) {
    const double x = random.unit();
    EXPECT_TRUE(x >= 0 && x < 1) << x;
    const double y = random.positive_unit();
    EXPECT_TRUE(y > 0 && y <= 1) << y;
    sum += x + y;
  }
  EXPECT_NEAR(sum / 20000, 0.5, 0.01);
}

TEST(Random, BelowGivesEveryNumberUnderTheBoundAndNoOther) {
  Random random(9);
  std::array<int, 7> seen{};
  for (int i = 0; i < 7000; ++i) {
    const std::uint64_t number = random.below(seen.size());
    ASSERT_LT(number, seen.size());
    ++seen[number];
  }
  for (const int times : seen) EXPECT_NEAR(times, 1000, 150);
}

TEST(Random, StreamsOfNeighbouringSeedsAndIndicesShareNoNumbers) {
  std::set<std::uint64_t> numbers;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint64_t index = 0; index < 20; ++index) {
      Random random(seed, index);
      for (int i = 0; i < 20; ++i) numbers.insert(random.next());
    }
  }
  EXPECT_EQ(numbers.size(), 20U * 20U * 20U);
}

}  // namespace
}  // namespace cellsweep
