/// @file
/// Lists that grow without initialising anything.
#include "base/memory/list.h"

#include <gmock/gmock.h>

#include <utility>
#include <vector>

#include "base/memory/starved.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;

List<int> list_of(std::initializer_list<int> numbers) {
  List<int> list;
  list.reserve(numbers.size());
  for (const int number : numbers) list.push(number);
  return list;
}

TEST(List, IsEmptyAtFirst) {
  List<int> list;
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(list.size(), 0U);
  EXPECT_EQ(list.bytes(), 0U);
  EXPECT_TRUE(list.view().empty());
  list.clear();
  EXPECT_TRUE(list.empty());
}

TEST(List, KeepsItsElementsInOrderWhileItGrows) {
  List<std::size_t> list;
  int moves = 0;
  for (std::size_t i = 0; i < 100'000; ++i) {
    const std::size_t* const before = list.data();
    list.reserve(i + 1);
    moves += list.data() != before ? 1 : 0;
    list.push(i);
  }
  ASSERT_EQ(list.size(), 100'000U);
  EXPECT_LE(moves, 40);
  for (std::size_t i = 0; i < list.size(); ++i) ASSERT_EQ(list[i], i);
}

TEST(List, HasRoomForAsManyAsWereAskedFor) {
  List<int> list;
  list.reserve(1000);
  const int* const place = list.data();
  EXPECT_GE(list.bytes(), 4000U);
  for (int i = 0; i < 1000; ++i) list.push(i);
  list.reserve(10);
  EXPECT_EQ(list.data(), place);
}

TEST(List, MayBeWrittenInItsRoomBeforeItIsThatLong) {
  List<int> list = list_of({1, 2});
  list.reserve(4);
  list.data()[2] = 3;
  list.data()[3] = 4;
  EXPECT_THAT(list.view(), ElementsAre(1, 2));
  list.set_size(4);
  EXPECT_THAT(list.view(), ElementsAre(1, 2, 3, 4));
  list[1] = 9;
  EXPECT_THAT(std::as_const(list).view(), ElementsAre(1, 9, 3, 4));
  list.clear();
  EXPECT_TRUE(list.empty());
  EXPECT_GE(list.bytes(), 16U);
}

TEST(List, GrowsToASizeWithOneValue) {
  List<int> list = list_of({1, 2});
  list.resize(5, 7);
  EXPECT_THAT(list.view(), ElementsAre(1, 2, 7, 7, 7));
  list.resize(1, 9);
  EXPECT_THAT(list.view(), ElementsAre(1));
  list.resize(2, 9);
  EXPECT_THAT(list.view(), ElementsAre(1, 9));
}

TEST(List, TakesMoreBehindThoseThatThereAreAndLosesSome) {
  List<int> list = list_of({1, 2});
  list.append(list_of({3, 4, 5, 6}));
  list.append({});
  EXPECT_THAT(list.view(), ElementsAre(1, 2, 3, 4, 5, 6));
  list.erase_if([](int number) { return number % 3 == 0; });
  EXPECT_THAT(list.view(), ElementsAre(1, 2, 4, 5));
  list.pop();
  EXPECT_THAT(list.view(), ElementsAre(1, 2, 4));
}

TEST(List, IsAsItWasWhenItCannotGrow) {
  List<int> list = list_of({5, 6, 7});
  EXPECT_TRUE(fails_at(1, [&] { list.reserve(10'000); }));
  EXPECT_THAT(list.view(), ElementsAre(5, 6, 7));
  list.reserve(10'000);
  EXPECT_THAT(list.view(), ElementsAre(5, 6, 7));
  const std::vector<int> more(100'000);
  EXPECT_TRUE(fails_at(1, [&] { list.append(more); }));
  EXPECT_TRUE(fails_at(1, [&] { list.resize(100'000, 1); }));
  EXPECT_THAT(list.view(), ElementsAre(5, 6, 7));
  List<int> empty;
  EXPECT_TRUE(fails_at(1, [&] { empty.reserve(1); }));
  EXPECT_EQ(empty.bytes(), 0U);
}

TEST(List, GivesItsMemoryBackWhenAnEmptyOneTakesItsPlace) {
  List<int> list = list_of({1, 2, 3});
  list = {};
  EXPECT_EQ(list.bytes(), 0U);
  EXPECT_TRUE(list.empty());
}

}  // namespace
}  // namespace cellsweep
