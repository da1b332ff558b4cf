/// @file
/// Steps C9 and C10 of cell-paper: which IDs changed, and the list of them.
#include <gmock/gmock.h>

#include <random>

#include "engines/cell/spu/paper/change_detection.h"
#include "engines/cell/spu/paper/compaction.h"
#include "engines/cell/spu/paper/intervector_sort.h"
#include "engines/cell/spu/paper/intravector_sort.h"
#include "engines/cell/tracked_array.h"

namespace cellsweep::cell::paper {
namespace {

using testing::ElementsAre;

constexpr auto kSentinel = static_cast<std::int32_t>(kUnchanged);

std::uint32_t max_of(std::uint32_t id) {
  return id | kMaximumFlag;
}

/// The IDs that steps C5 to C10 report for an array, descending.
std::vector<std::int32_t> changed_ids(const TrackedArray& given, bool literal) {
  TrackedArray after = given;
  intervector_sort(after.values.data(), after.ids.data(), after.vectors());
  intravector_sort(after.values.data(), after.ids.data(), after.vectors());
  if (!literal) order_equal_values(after.values.data(), after.ids.data(), after.count());
  const BeforeAndAfter axis{given.values.data(), after.values.data(), after.ids.data(), given.count()};
  DmaVector<std::uint32_t> ids = given.ids;
  literal ? compare_changes_literal(axis, ids.data()) : compare_changes(axis, ids.data());
  std::vector<std::int32_t> words(ids.begin(), ids.end());
  reverse_quicksort(words.data(), given.count());
  words.resize(remove_duplicates(words.data(), given.count(), kSentinel));
  return words;
}

std::vector<std::int32_t> changed_ids(const TrackedArray& given) {
  return changed_ids(given, false);
}

TEST(Compaction, GivesTheDocumentsExample) {
  std::vector<std::int32_t> words = {0, 3, 0, 4, 3, 4, 0, 1, 0};
  reverse_quicksort(words.data(), 9);
  EXPECT_THAT(words, ElementsAre(4, 4, 3, 3, 1, 0, 0, 0, 0));
  // The document writes 4310: its sentinel 0 ends the list.
  const std::uint32_t count = remove_duplicates(words.data(), 9, 0);
  words.resize(count);
  EXPECT_THAT(words, ElementsAre(4, 3, 1));
}

TEST(Compaction, LeavesNothingOfSentinelsOnly) {
  for (const std::uint32_t count : {0U, 1U, 2U, 3U, 4096U}) {
    std::vector<std::int32_t> words(count, kSentinel);
    reverse_quicksort(words.data(), count);
    EXPECT_EQ(words, std::vector<std::int32_t>(count, kSentinel));
    EXPECT_EQ(remove_duplicates(words.data(), count, kSentinel), 0U);
  }
}

TEST(Compaction, SortsAsTheStandardLibraryDoes) {
  std::mt19937 random(3);
  for (std::uint32_t count = 0; count < 200; ++count) {
    std::vector<std::int32_t> words(count);
    for (std::int32_t& word : words) word = static_cast<std::int32_t>(random() % (count / 3 + 2)) - 1;
    std::vector<std::int32_t> expected = words;
    std::sort(expected.rbegin(), expected.rend());
    reverse_quicksort(words.data(), count);
    ASSERT_EQ(words, expected);
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    std::erase(expected, kSentinel);
    words.resize(remove_duplicates(words.data(), count, kSentinel));
    ASSERT_EQ(words, expected);
  }
}

TEST(Changes, ASortedArrayHasNone) {
  EXPECT_TRUE(changed_ids(TrackedArray({0, 1, 2, 3}, {1, max_of(1), 2, max_of(2)})).empty());
}

TEST(Changes, ValuesThatMoveButKeepTheirOrderAreNone) {
  // What the host refills is in last frame's order, so only the order can differ (C3).
  EXPECT_TRUE(changed_ids(TrackedArray({-7, 1, 4, 400}, {1, 2, max_of(1), max_of(2)})).empty());
}

TEST(Changes, TwoEndpointsThatPassEachOtherAreBothReported) {
  EXPECT_THAT(changed_ids(TrackedArray({0, 2, 1, 3, 8, 9}, {1, max_of(1), 2, max_of(2), 3, max_of(3)})),
              ElementsAre(2, 1));
}

TEST(Changes, ATouchThatBeginsWithoutAValueChangingPlaceIsReported) {
  const TrackedArray touching({0, 1, 1, 2}, {1, max_of(1), 2, max_of(2)});
  EXPECT_THAT(changed_ids(touching), ElementsAre(2, 1));
  EXPECT_TRUE(changed_ids(TrackedArray({0, 1, 1, 2}, {1, 2, 1, 2}), true).empty())
      << "values alone cannot see it";
}

TEST(Changes, ATouchThatEndsIsReported) {
  EXPECT_THAT(changed_ids(TrackedArray({0, 1.5F, 1, 2}, {1, 2, max_of(1), max_of(2)})), ElementsAre(2, 1));
}

TEST(Changes, EqualValuesAreOrderedMinimaFirstThenById) {
  const std::vector<float> values(6, 5);
  std::vector<std::uint32_t> ids = {max_of(2), 3, max_of(1), 1, max_of(3), 2};
  order_equal_values(values.data(), ids.data(), 6);
  EXPECT_THAT(ids, ElementsAre(1, 2, 3, max_of(1), max_of(2), max_of(3)));
}

TEST(Changes, OnlyEqualValuesChangePlacesInThatOrder) {
  const std::vector<float> values = {1, 2, 2, 3};
  std::vector<std::uint32_t> ids = {max_of(9), max_of(2), 4, 1};
  order_equal_values(values.data(), ids.data(), 4);
  EXPECT_THAT(ids, ElementsAre(max_of(9), 4, max_of(2), 1));
}

TEST(Changes, EqualValuesInOrderStayUnreportedHoweverTheSortShufflesThem) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t id = 1; id <= 21; ++id) ids.push_back(id);
  for (std::uint32_t id = 1; id <= 21; ++id) ids.push_back(max_of(id));
  EXPECT_TRUE(changed_ids(TrackedArray(std::vector<float>(42, 1.0F), ids)).empty());
}

TEST(Changes, SentinelsOnlyAreNone) {
  TrackedArray array({}, {});
  array.values.assign(8, std::bit_cast<float>(kPaddingValueBits));
  array.ids.assign(8, kUnchanged);
  EXPECT_TRUE(changed_ids(array).empty());
}

TEST(Changes, ANewArrayIsReportedWholeButForItsPadding) {
  TrackedArray array({0, 1, 2, 3, 4, 5}, {1, max_of(1), 2, max_of(2), 3, max_of(3)});
  mark_all_changed(array.ids.data(), array.count());
  EXPECT_THAT(array.ids, ElementsAre(1, 1, 2, 2, 3, 3, kUnchanged, kUnchanged));
}

// The exactness of C9 on small arrays: whenever the overlap of two bodies is not what it was, one is
// reported.
TEST(Changes, ABodyOfEveryPairWhoseOverlapChangesIsReported) {
  std::mt19937 random(5);
  constexpr std::uint32_t kBodies = 5;
  const auto random_interval = [&] {
    const auto low = static_cast<float>(random() % 6);
    return std::pair(low, low + static_cast<float>(random() % 3));
  };
  const auto overlapping = [](auto a, auto b) { return a.first <= b.second && b.first <= a.second; };
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::pair<float, float>> before(kBodies);
    std::vector<std::pair<float, float>> now(kBodies);
    std::vector<std::pair<float, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < kBodies; ++i) {
      before[i] = random_interval();
      now[i] = random() % 2 == 0 ? before[i] : random_interval();
      order.emplace_back(before[i].first, i + 1);
      order.emplace_back(before[i].second, max_of(i + 1));
    }
    std::sort(order.begin(), order.end());
    std::vector<float> values;
    std::vector<std::uint32_t> ids;
    for (const auto& [value, id] : order) {
      const auto& interval = now[(id & ~kMaximumFlag) - 1];
      values.push_back((id & kMaximumFlag) != 0 ? interval.second : interval.first);
      ids.push_back(id);
    }
    const auto changed = changed_ids(TrackedArray(values, ids));
    const auto is_reported = [&](std::uint32_t i) {
      return std::ranges::count(changed, static_cast<std::int32_t>(i + 1)) == 1;
    };
    for (std::uint32_t i = 0; i < kBodies; ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        if (overlapping(before[i], before[j]) == overlapping(now[i], now[j])) continue;
        ASSERT_TRUE(is_reported(i) || is_reported(j)) << "round " << round;
      }
    }
  }
}

}  // namespace
}  // namespace cellsweep::cell::paper
