/// @file
/// Single events in, the current set and its changes out (X6).
#include "broadphase/pair_tracker.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "contract/random.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(PairTracker, ANewTrackerHasNoPairsAndNothingToTell) {
  PairTracker tracker;
  const PairChanges changes = tracker.commit();
  EXPECT_THAT(changes.began, IsEmpty());
  EXPECT_THAT(changes.ended, IsEmpty());
  EXPECT_THAT(tracker.pairs(), IsEmpty());
}

TEST(PairTracker, ChangesComeInAscendingOrder) {
  PairTracker tracker;
  for (const Pair pair : {Pair{7, 9}, Pair{0, 0xffffffff}, Pair{0x80000000, 0x80000001}, Pair{0, 3}}) {
    tracker.note(pair, true);
  }
  EXPECT_THAT(tracker.commit().began,
              ElementsAre(Pair{0, 3}, Pair{0, 0xffffffff}, Pair{7, 9}, Pair{0x80000000, 0x80000001}));
  for (const Pair pair : {Pair{7, 9}, Pair{0x80000000, 0x80000001}, Pair{0, 3}}) tracker.note(pair, false);
  EXPECT_THAT(tracker.commit().ended, ElementsAre(Pair{0, 3}, Pair{7, 9}, Pair{0x80000000, 0x80000001}));
  EXPECT_THAT(tracker.pairs(), ElementsAre(Pair{0, 0xffffffff}));
}

TEST(PairTracker, NotesWaitForTheCommit) {
  PairTracker tracker;
  tracker.note({1, 2}, true);
  EXPECT_THAT(tracker.pairs(), IsEmpty());
  tracker.commit();
  tracker.note({1, 2}, false);
  EXPECT_THAT(tracker.pairs(), ElementsAre(Pair{1, 2}));
}

TEST(PairTracker, TheLastWordOnAPairCounts) {
  PairTracker tracker;
  for (const bool overlapping : {true, false, true}) tracker.note({1, 2}, overlapping);
  for (const bool overlapping : {true, false}) tracker.note({3, 4}, overlapping);
  EXPECT_THAT(tracker.commit().began, ElementsAre(Pair{1, 2}));
  for (const bool overlapping : {false, true}) tracker.note({1, 2}, overlapping);
  const PairChanges changes = tracker.commit();
  EXPECT_THAT(changes.began, IsEmpty());
  EXPECT_THAT(changes.ended, IsEmpty());
  EXPECT_THAT(tracker.pairs(), ElementsAre(Pair{1, 2}));
}

TEST(PairTracker, WhatIsKnownAlreadyIsNoChange) {
  PairTracker tracker;
  tracker.note({1, 2}, true);
  tracker.commit();
  tracker.note({1, 2}, true);
  tracker.note({3, 4}, false);
  const PairChanges changes = tracker.commit();
  EXPECT_THAT(changes.began, IsEmpty());
  EXPECT_THAT(changes.ended, IsEmpty());
}

TEST(PairTracker, ACommitWithoutNotesTellsNothingAgain) {
  PairTracker tracker;
  tracker.note({1, 2}, true);
  tracker.commit();
  EXPECT_THAT(tracker.commit().began, IsEmpty());
  EXPECT_THAT(tracker.pairs(), ElementsAre(Pair{1, 2}));
}

/// Up to 200 notes on 66 pairs, so that many are noted several times; returns the last word on each.
std::map<Pair, bool> note_some(PairTracker& tracker, contract::Random& random) {
  std::map<Pair, bool> last_words;
  for (std::size_t notes = random.below(200); notes > 0; --notes) {
    const auto one = static_cast<BodyId>(random.below(12) * 0x10000001);
    const auto other = static_cast<BodyId>(random.below(12) * 0x10000001);
    if (one == other) continue;
    const bool overlapping = random.one_in(2);
    tracker.note(make_pair_of(one, other), overlapping);
    last_words[make_pair_of(one, other)] = overlapping;
  }
  return last_words;
}

TEST(PairTracker, AgreesWithASetOverHundredsOfCommits) {
  contract::Random random(4);
  PairTracker tracker;
  std::set<Pair> truth;
  for (int commit = 0; commit < 400; ++commit) {
    std::vector<Pair> began;
    std::vector<Pair> ended;
    for (const auto& [pair, overlapping] : note_some(tracker, random)) {
      if (overlapping && truth.insert(pair).second) began.push_back(pair);
      if (!overlapping && truth.erase(pair) == 1) ended.push_back(pair);
    }
    const PairChanges changes = tracker.commit();
    ASSERT_TRUE(std::ranges::equal(changes.began, began)) << "commit " << commit;
    ASSERT_TRUE(std::ranges::equal(changes.ended, ended)) << "commit " << commit;
    std::vector<Pair> sorted(tracker.pairs().begin(), tracker.pairs().end());
    std::ranges::sort(sorted);
    ASSERT_TRUE(std::ranges::equal(sorted, truth)) << "commit " << commit;
  }
}

TEST(PairTracker, TheOrderOfPairsDependsOnTheNotesAlone) {
  PairTracker one;
  PairTracker other;
  contract::Random one_random(5);
  contract::Random other_random(5);
  for (int commit = 0; commit < 50; ++commit) {
    note_some(one, one_random);
    one.commit();
    note_some(other, other_random);
    other.commit();
    ASSERT_TRUE(std::ranges::equal(one.pairs(), other.pairs())) << "commit " << commit;
  }
}

}  // namespace
}  // namespace cellsweep
