/// @file
/// Single events in, the changes of the current set out (X6).
#include "engines/common/pair_tracker.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

#include "contract/random.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Slot kLast = kSlotMask - 1;

TEST(PairTracker, ANewTrackerHasNoPairsAndNothingToTell) {
  PairTracker tracker;
  const FoundPairs found = tracker.commit();
  EXPECT_THAT(found.began, IsEmpty());
  EXPECT_THAT(found.ended, IsEmpty());
  EXPECT_THAT(found.more_began, IsEmpty());
  EXPECT_FALSE(found.is_whole_set);
  EXPECT_EQ(tracker.size(), 0U);
}

TEST(PairTracker, ChangesComeInAscendingOrder) {
  PairTracker tracker;
  for (const SlotPair pair : {SlotPair{7, 9}, SlotPair{0, kLast}, SlotPair{kLast - 1, kLast}, SlotPair{0, 3}})
    tracker.note(pair, true);
  EXPECT_THAT(tracker.commit().began,
              ElementsAre(SlotPair{0, 3}, SlotPair{0, kLast}, SlotPair{7, 9}, SlotPair{kLast - 1, kLast}));
  for (const SlotPair pair : {SlotPair{7, 9}, SlotPair{kLast - 1, kLast}, SlotPair{0, 3}})
    tracker.note(pair, false);
  EXPECT_THAT(tracker.commit().ended,
              ElementsAre(SlotPair{0, 3}, SlotPair{7, 9}, SlotPair{kLast - 1, kLast}));
  EXPECT_EQ(tracker.size(), 1U);
}

TEST(PairTracker, NotesWaitForTheCommit) {
  PairTracker tracker;
  tracker.note({1, 2}, true);
  EXPECT_EQ(tracker.size(), 0U);
  tracker.commit();
  tracker.note({1, 2}, false);
  EXPECT_EQ(tracker.size(), 1U);
}

TEST(PairTracker, TheLastWordOnAPairCounts) {
  PairTracker tracker;
  for (const bool overlapping : {true, false, true}) tracker.note({1, 2}, overlapping);
  for (const bool overlapping : {true, false}) tracker.note({3, 4}, overlapping);
  EXPECT_THAT(tracker.commit().began, ElementsAre(SlotPair{1, 2}));
  for (const bool overlapping : {false, true}) tracker.note({1, 2}, overlapping);
  const FoundPairs found = tracker.commit();
  EXPECT_THAT(found.began, IsEmpty());
  EXPECT_THAT(found.ended, IsEmpty());
  EXPECT_EQ(tracker.size(), 1U);
}

TEST(PairTracker, WhatIsKnownAlreadyIsNoChange) {
  PairTracker tracker;
  tracker.note({1, 2}, true);
  tracker.commit();
  tracker.note({1, 2}, true);
  tracker.note({3, 4}, false);
  const FoundPairs found = tracker.commit();
  EXPECT_THAT(found.began, IsEmpty());
  EXPECT_THAT(found.ended, IsEmpty());
}

TEST(PairTracker, ACommitWithoutNotesTellsNothingAgain) {
  PairTracker tracker;
  tracker.note({1, 2}, true);
  tracker.commit();
  EXPECT_THAT(tracker.commit().began, IsEmpty());
  EXPECT_EQ(tracker.size(), 1U);
}

/// Up to 200 notes on 66 pairs, so that many are noted several times; returns the last word on each.
std::map<SlotPair, bool> note_some(PairTracker& tracker, contract::Random& random) {
  std::map<SlotPair, bool> last_words;
  for (std::size_t notes = random.below(200); notes > 0; --notes) {
    const auto one = static_cast<Slot>(random.below(12) * 0x01000001);
    const auto other = static_cast<Slot>(random.below(12) * 0x01000001);
    if (one == other) continue;
    const bool overlapping = random.one_in(2);
    tracker.note(make_slot_pair(one, other), overlapping);
    last_words[make_slot_pair(one, other)] = overlapping;
  }
  return last_words;
}

TEST(PairTracker, AgreesWithASetOverHundredsOfCommits) {
  contract::Random random(4);
  PairTracker tracker;
  std::set<SlotPair> truth;
  for (int commit = 0; commit < 400; ++commit) {
    std::vector<SlotPair> began;
    std::vector<SlotPair> ended;
    for (const auto& [pair, overlapping] : note_some(tracker, random)) {
      if (overlapping && truth.insert(pair).second) began.push_back(pair);
      if (!overlapping && truth.erase(pair) == 1) ended.push_back(pair);
    }
    const FoundPairs found = tracker.commit();
    ASSERT_TRUE(std::ranges::equal(found.began, began)) << "commit " << commit;
    ASSERT_TRUE(std::ranges::equal(found.ended, ended)) << "commit " << commit;
    ASSERT_EQ(tracker.size(), truth.size()) << "commit " << commit;
  }
}

}  // namespace
}  // namespace cellsweep
