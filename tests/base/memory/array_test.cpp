/// @file
/// Arrays that initialise nothing and give memory back.
#include "base/memory/array.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "base/memory/starved.h"

namespace cellsweep {
namespace {

TEST(Array, IsEmptyAtFirst) {
  Array<int> array;
  EXPECT_EQ(array.size(), 0U);
  EXPECT_EQ(array.bytes(), 0U);
  EXPECT_TRUE(array.view().empty());
  array.renew(0);
  EXPECT_TRUE(array.view().empty());
}

TEST(Array, IsAsLongAsItWasMadeLast) {
  Array<std::uint32_t> array;
  for (const std::size_t size : {1, 1000, 3, 100'000, 99'999, 0, 5}) {
    array.renew(size);
    ASSERT_EQ(array.size(), size);
    ASSERT_EQ(array.view().size(), size);
    ASSERT_GE(array.bytes(), size * sizeof(std::uint32_t));
    std::fill_n(array.data(), size, 7U);
  }
}

TEST(Array, KeepsItsFirstElementsWhenItShrinks) {
  Array<int> array;
  array.renew(4);
  for (int i = 0; i < 4; ++i) array.data()[i] = 10 * i;
  array.shrink(2);
  EXPECT_THAT(array.view(), testing::ElementsAre(0, 10));
}

TEST(Array, OfALittleLessOrMoreStaysWhereItIs) {
  Array<int> array;
  array.renew(10'000);
  const int* const place = array.data();
  for (const std::size_t size : {10'100, 9000, 5000, 10'001}) {
    array.renew(size);
    EXPECT_EQ(array.data(), place) << size;
  }
}

TEST(Array, GivesMemoryBackWhenMuchLessIsNeeded) {
  Array<int> array;
  array.renew(1'000'000);
  EXPECT_GE(array.bytes(), 4'000'000U);
  array.renew(10);
  EXPECT_LE(array.bytes(), 1000U);
  array.renew(3000);
  array.renew(10);
  EXPECT_GE(array.bytes(), 12'000U) << "of little it is not worth the while";
}

TEST(Array, IsEmptyAfterMemoryFailedAndMayBeRenewed) {
  Array<int> array;
  array.renew(10);
  EXPECT_TRUE(fails_at(1, [&] { array.renew(100'000); }));
  EXPECT_EQ(array.size(), 0U);
  EXPECT_EQ(array.bytes(), 0U);
  array.renew(100'000);
  EXPECT_EQ(array.size(), 100'000U);
}

TEST(Array, ChangesHandsWithItsElements) {
  Array<int> one;
  Array<int> other;
  one.renew(2);
  one.data()[0] = 3;
  one.data()[1] = 4;
  std::swap(one, other);
  EXPECT_THAT(other.view(), testing::ElementsAre(3, 4));
  EXPECT_TRUE(one.view().empty());
  one.renew(5);
  EXPECT_THAT(other.view(), testing::ElementsAre(3, 4));
}

TEST(MakeRoom, OfAContainerThatGrowsALittleAtATimeSeldomMovesIt) {
  std::vector<int> numbers;
  int moves = 0;
  for (int i = 0; i < 10'000; ++i) {
    const int* const before = numbers.data();
    make_room(numbers, numbers.size() + 1);
    numbers.push_back(i);
    moves += numbers.data() != before ? 1 : 0;
  }
  EXPECT_LE(moves, 30);
  make_room(numbers, 5);
  EXPECT_EQ(numbers.size(), 10'000U);
  make_room(numbers, 1'000'000);
  EXPECT_GE(numbers.capacity(), 1'000'000U);
  EXPECT_EQ(numbers.back(), 9999);
}

}  // namespace
}  // namespace cellsweep
