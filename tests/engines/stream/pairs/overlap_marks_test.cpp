/// @file
/// Which candidates overlap, tested all, or those with new boxes, or from the start.
#include "engines/stream/pairs/overlap_marks.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "base/threads/numbers_of_workers.h"
#include "base/threads/thread_pool.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using Pairs = std::vector<SlotPair>;
using testing::IsEmpty;

/// Boxes, candidates among them, and which of them overlap.
class OverlapMarksTest : public testing::TestWithParam<unsigned> {
 protected:
  OverlapMarksTest() : boxes_(uniform_boxes(300, 1)), fresh_(boxes_.size(), 0) {}

  /// Adds some candidates and takes others away.
  void change_candidates(std::size_t steps) {
    const Pairs before = candidates_;
    std::set<SlotPair> set(before.begin(), before.end());
    for (std::size_t i = 0; i < steps; ++i) {
      const auto a = static_cast<Slot>(random_.below(boxes_.size() - 1));
      const SlotPair pair{a, static_cast<Slot>(a + 1 + random_.below(boxes_.size() - 1 - a))};
      if (!set.erase(pair)) set.insert(pair);
    }
    replace_candidates({set.begin(), set.end()});
  }

  // A candidate that is new is one because a box of it is.
  void replace_candidates(const Pairs& next) {
    const Pairs before = std::exchange(candidates_, next);
    began_.clear();
    ended_.clear();
    std::ranges::set_difference(candidates_, before, std::back_inserter(began_));
    std::ranges::set_difference(before, candidates_, std::back_inserter(ended_));
    for (const SlotPair& pair : began_) fresh_[pair.a] = 1;
  }

  void move_some() {
    std::ranges::fill(fresh_, std::uint8_t{0});
    for (std::size_t i = random_.below(4); i < boxes_.size(); i += 4) {
      boxes_[i] = cube_in(random_, 6, 13);
      fresh_[i] = 1;
    }
  }

  Pairs truth() const {
    Pairs pairs;
    for (const SlotPair& pair : candidates_) {
      if (overlap(boxes_[pair.a], boxes_[pair.b])) pairs.push_back(pair);
    }
    return pairs;
  }

  Pairs marked() const {
    Array<SlotPair> list;
    list.renew(candidates_.size());
    std::ranges::copy(candidates_, list.data());
    marks_.leave_marked(list);
    return {list.view().begin(), list.view().end()};
  }

  void test_all() {
    marks_.test_all(crew_, candidates_, boxes_.data());
    EXPECT_EQ(marked(), truth());
  }

  /// Tests those with new boxes, or all; expects right marks, and right changes.
  void refresh(bool fresh_ones) {
    const Pairs& before = known_;
    const TestedBoxes tested{boxes_.data(), fresh_ones ? fresh_.data() : nullptr};
    expect(marks_.refresh(crew_, candidates_, {began_, ended_}, tested, room_), before);
  }

  /// Other candidates, all tested, compared with the pairs before.
  void compare(const Pairs& next) {
    candidates_ = next;
    marks_.test_all(crew_, candidates_, boxes_.data());
    expect(marks_.compare(known_, candidates_, room_), known_);
  }

  void expect(const SlotPairChanges& changes, const Pairs& before) {
    const Pairs now = truth();
    Pairs began;
    Pairs ended;
    std::ranges::set_difference(now, before, std::back_inserter(began));
    std::ranges::set_difference(before, now, std::back_inserter(ended));
    EXPECT_TRUE(std::ranges::equal(changes.began, began));
    EXPECT_TRUE(std::ranges::equal(changes.ended, ended));
    EXPECT_EQ(marked(), now);
    known_ = now;
  }

  contract::Random random_{2};
  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
  std::vector<Aabb> boxes_;
  std::vector<std::uint8_t> fresh_;
  Pairs candidates_, began_, ended_;
  Pairs known_;  // that overlapped at the last test
  OverlapMarks marks_;
  PairRoom room_;
};

TEST_P(OverlapMarksTest, SayWhichOverlappedBeforeSomeBoxesChanged) {
  marks_.test_all(crew_, {}, BoxesBefore{});
  EXPECT_THAT(marked(), IsEmpty());
  change_candidates(400);
  for (int round = 0; round < 20; ++round) {
    const Pairs expected = truth();
    const std::vector<Aabb> before = boxes_;
    move_some();
    marks_.test_all(crew_, candidates_, BoxesBefore{boxes_.data(), SlotBoxes(before), fresh_.data()});
    EXPECT_EQ(marked(), expected);
  }
}

TEST_P(OverlapMarksTest, SayWhichOverlapWhenAllAreTested) {
  test_all();
  for (int round = 0; round < 20; ++round) {
    change_candidates(100);
    move_some();
    test_all();
  }
  EXPECT_GT(marked().size(), 10U);
}

TEST_P(OverlapMarksTest, TellWhatBeganAndEndedWhicheverWayTheyAreTested) {
  change_candidates(400);
  test_all();
  known_ = truth();
  for (int round = 0; round < 100 && !HasFailure(); ++round) {
    move_some();
    change_candidates(random_.below(3) * 20);
    refresh(round % 2 == 0);
  }
  EXPECT_GT(known_.size(), 10U);
}

TEST_P(OverlapMarksTest, TellWhatEndedWhereAllCandidatesEnd) {
  change_candidates(400);
  test_all();
  known_ = truth();
  replace_candidates({});
  refresh(false);
  change_candidates(400);
  refresh(true);
  replace_candidates({candidates_[7]});
  refresh(true);
}

TEST_P(OverlapMarksTest, TellWhatBeganAndEndedWhereAllCandidatesAreOthers) {
  compare({});
  for (int round = 0; round < 50 && !HasFailure(); ++round) {
    change_candidates(round % 5 == 0 ? 400 : 40);
    if (round % 2 == 0) move_some();
    compare(candidates_);
  }
  EXPECT_GT(known_.size(), 10U);
  compare({});
  EXPECT_THAT(known_, IsEmpty());
}

TEST_P(OverlapMarksTest, MayBeThatAllOverlap) {
  change_candidates(100);
  marks_.mark_all(candidates_.size());
  EXPECT_EQ(marked(), candidates_);
}

// Whichever share of the candidates it falls into, and behind or before all that there are.
TEST_P(OverlapMarksTest, TellWhatASingleChangeDid) {
  change_candidates(60);
  test_all();
  known_ = truth();
  const Pairs all = candidates_;
  for (std::size_t gone = 0; gone < all.size(); ++gone) {
    Pairs others = all;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(gone));
    replace_candidates(others);
    refresh(false);
    replace_candidates(all);
    std::ranges::fill(fresh_, std::uint8_t{0});
    fresh_[all[gone].b] = 1;
    refresh(true);
  }
}

TEST_P(OverlapMarksTest, AreAsGoodForFewerCandidatesThanWorkers) {
  for (std::size_t count = 0; count < 5; ++count) {
    Pairs few;
    for (Slot slot = 0; slot < count; ++slot) few.push_back({slot, slot + 1});
    replace_candidates(few);
    refresh(false);
    move_some();
    began_.clear();
    ended_.clear();
    refresh(true);
    test_all();
    known_ = truth();
  }
}

TEST_P(OverlapMarksTest, AreAsGoodForVeryManyCandidates) {
  change_candidates(100'000);
  ASSERT_GE(candidates_.size(), 20'000U);
  test_all();
  known_ = truth();
  for (int round = 0; round < 4; ++round) {
    move_some();
    change_candidates(round % 2 == 0 ? 0 : 300);
    refresh(false);
  }
  EXPECT_GE(marks_.bytes(), candidates_.size());
}

INSTANTIATE_TEST_SUITE_P(Workers, OverlapMarksTest, numbers_of_workers());

}  // namespace
}  // namespace cellsweep::stream
