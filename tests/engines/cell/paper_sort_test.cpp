/// @file
/// Steps C5 to C8 of cell-paper: the sort, and the IDs that follow it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "engines/cell/spu/paper/intervector_sort.h"
#include "engines/cell/spu/paper/intravector_sort.h"
#include "engines/cell/tracked_array.h"

namespace cellsweep::cell::paper {
namespace {

using Lanes = std::array<float, 4>;
using Ids = std::array<std::uint32_t, 4>;

Tracked tracked(const Lanes& values, const Ids& ids) {
  return {vec_float4{values[0], values[1], values[2], values[3]}, vec_uint4{ids[0], ids[1], ids[2], ids[3]}};
}

Lanes values_of(const Tracked& t) {
  return {t.values[0], t.values[1], t.values[2], t.values[3]};
}

Ids ids_of(const Tracked& t) {
  return {t.ids[0], t.ids[1], t.ids[2], t.ids[3]};
}

/// Runs both sorts; checks order, and that each value kept its ID.
void expect_sorts(const TrackedArray& given) {
  for (const EarlyOut early_out : {EarlyOut::yes, EarlyOut::no}) {
    TrackedArray array = given;
    intervector_sort(array.values.data(), array.ids.data(), array.vectors(), early_out);
    intravector_sort(array.values.data(), array.ids.data(), array.vectors());
    ASSERT_TRUE(std::is_sorted(array.values.begin(), array.values.end()));
    ASSERT_EQ(array.sorted_pairs(), given.sorted_pairs());
  }
}

/// C5 as it is written down: each vector goes all the way before the next one starts.
void insert_one_by_one(TrackedArray& array, EarlyOut early_out) {
  const auto at = [&](std::uint32_t i) { return load(array.values.data(), array.ids.data(), i); };
  const auto any_above = [](const Lanes& neighbour, const Lanes& inserted) {
    return *std::max_element(neighbour.begin(), neighbour.end()) >
           *std::min_element(inserted.begin(), inserted.end());
  };
  for (std::uint32_t i = 1; i < array.vectors(); ++i) {
    Tracked inserted = at(i);
    std::uint32_t j = i;
    for (; j > 0; --j) {
      Tracked neighbour = at(j - 1);
      if (early_out == EarlyOut::yes && !any_above(values_of(neighbour), values_of(inserted))) break;
      split(inserted, neighbour);
      store(neighbour, array.values.data(), array.ids.data(), j);
    }
    store(inserted, array.values.data(), array.ids.data(), j);
  }
}

TEST(SplitLanes, MovesIdsAsFigure4_7Does) {
  Tracked high = tracked({5, 6, 7, 8}, {10, 20, 30, 40});
  Tracked low = tracked({1, 7, 6, 4}, {50, 60, 70, 80});
  split_lanes(low, high);
  EXPECT_EQ(values_of(high), (Lanes{5, 7, 7, 8}));
  EXPECT_EQ(ids_of(high), (Ids{10, 60, 30, 40}));
  EXPECT_EQ(values_of(low), (Lanes{1, 6, 6, 4}));
  EXPECT_EQ(ids_of(low), (Ids{50, 20, 70, 80}));
}

TEST(SplitLanes, LeavesEqualValuesWithTheirIds) {
  Tracked high = tracked({1, 1, 2, 2}, {1, 2, 3, 4});
  Tracked low = tracked({1, 1, 2, 2}, {5, 6, 7, 8});
  split_lanes(low, high);
  EXPECT_EQ(ids_of(high), (Ids{1, 2, 3, 4}));
  EXPECT_EQ(ids_of(low), (Ids{5, 6, 7, 8}));
}

TEST(IntervectorSort, EndsToTheBitAsIfOneVectorWentAfterTheOther) {
  std::mt19937 random(12);
  for (std::uint32_t round = 0; round < 3000; ++round) {
    const std::uint32_t vectors = 1 + round % 17;
    TrackedArray array(std::vector<float>(4 * vectors));
    const std::uint32_t values = round % 2 == 0 ? 6 : 1000;
    const std::uint32_t disorder = round % 3 == 0 ? 0 : values;
    for (std::uint32_t i = 0; i < array.count(); ++i)
      array.values[i] = static_cast<float>(i + random() % (disorder + 3));
    for (const EarlyOut early_out : {EarlyOut::yes, EarlyOut::no}) {
      TrackedArray expected = array;
      TrackedArray sorted = array;
      insert_one_by_one(expected, early_out);
      intervector_sort(sorted.values.data(), sorted.ids.data(), vectors, early_out);
      ASSERT_TRUE(sorted.values == expected.values && sorted.ids == expected.ids) << "round " << round;
    }
  }
}

TEST(Split, EndsWithEveryElementOfOneVectorAboveEveryElementOfTheOther) {
  for (unsigned code = 0; code < 6561; ++code) {  // eight digits of base 3
    TrackedArray array({0, 0, 0, 0, 0, 0, 0, 0});
    unsigned rest = code;
    for (float& value : array.values) {
      value = static_cast<float>(rest % 3);
      rest /= 3;
    }
    const auto before = array.sorted_pairs();
    Tracked low = load(array.values.data(), array.ids.data(), 0);
    Tracked high = load(array.values.data(), array.ids.data(), 1);
    split(low, high);
    store(low, array.values.data(), array.ids.data(), 0);
    store(high, array.values.data(), array.ids.data(), 1);
    const auto middle = array.values.begin() + 4;
    ASSERT_LE(*std::max_element(array.values.begin(), middle), *std::min_element(middle, array.values.end()));
    ASSERT_EQ(array.sorted_pairs(), before);
  }
}

TEST(SortElements, MovesIdsAsFigure4_6Does) {
  Tracked t = tracked({10, 5, 30, 15}, {1, 2, 3, 4});
  sort_elements(t);
  EXPECT_EQ(values_of(t), (Lanes{5, 10, 15, 30}));
  EXPECT_EQ(ids_of(t), (Ids{2, 1, 4, 3}));
}

TEST(SortElements, SortsEverySmallIntegerVectorAndKeepsItsIdsAPermutation) {
  constexpr unsigned kDigits = 5;
  for (unsigned code = 0; code < kDigits * kDigits * kDigits * kDigits; ++code) {
    const Lanes given = {static_cast<float>(code % kDigits), static_cast<float>(code / kDigits % kDigits),
                         static_cast<float>(code / kDigits / kDigits % kDigits),
                         static_cast<float>(code / kDigits / kDigits / kDigits)};
    Tracked t = tracked(given, {0, 1, 2, 3});
    sort_elements(t);
    const Lanes values = values_of(t);
    Ids ids = ids_of(t);
    ASSERT_TRUE(std::is_sorted(values.begin(), values.end())) << code;
    for (std::size_t i = 0; i < 4; ++i) ASSERT_EQ(values[i], given[ids[i]]) << code;
    std::sort(ids.begin(), ids.end());
    ASSERT_EQ(ids, (Ids{0, 1, 2, 3})) << code;
  }
}

TEST(Sort, SortsArraysOfManyLengthsAndManyEqualValues) {
  std::mt19937 random(7);
  for (unsigned count = 0; count <= 70; ++count) {
    for (const unsigned distinct : {1U, 2U, 5U, 1000U}) {
      std::vector<float> values(count);
      for (float& value : values) value = static_cast<float>(random() % distinct) - 2;
      expect_sorts(TrackedArray(values));
    }
  }
}

TEST(Sort, SortsArraysThatAreSortedTheOtherWayRound) {
  std::vector<float> values;
  for (int i = 200; i > 0; --i) values.push_back(static_cast<float>(i));
  expect_sorts(TrackedArray(values));
}

TEST(Sort, LeavesAnArrayOfSentinelsOnly) {
  TrackedArray array({}, {});
  array.values.assign(12, std::bit_cast<float>(kPaddingValueBits));
  array.ids.assign(12, kUnchanged);
  expect_sorts(array);
}

TEST(Sort, PutsTheLargestFiniteValuesBelowThePadding) {
  const float largest = std::bit_cast<float>(0x7f7fffffU);
  expect_sorts(TrackedArray({largest, -largest, largest, 0, -largest}));
}

}  // namespace
}  // namespace cellsweep::cell::paper
