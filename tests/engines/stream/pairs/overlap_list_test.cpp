#include "engines/stream/pairs/overlap_list.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "engines/stream/kernels/kernel.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

constexpr std::size_t kAny = ~std::size_t{0};

/// Boxes, candidates among them, and what is known to overlap.
class OverlapListTest : public testing::TestWithParam<unsigned> {
 protected:
  OverlapListTest() : pool_(GetParam()), boxes_(uniform_boxes(300, 1)), stamps_(boxes_.size()) {
    table_.reserve_for(ids_below(boxes_.size()));
    table_.append(ids_below(boxes_.size()));
    change_candidates(400);
  }

  /// Adds some candidates and takes others away; says which.
  void change_candidates(std::size_t steps) {
    const std::vector<Pair> before = candidates_;
    std::set<Pair> set(before.begin(), before.end());
    for (std::size_t i = 0; i < steps; ++i) {
      const auto a = static_cast<BodyId>(random_.below(boxes_.size() - 1));
      const Pair pair{a, static_cast<BodyId>(a + 1 + random_.below(boxes_.size() - 1 - a))};
      if (!set.erase(pair)) set.insert(pair);
    }
    candidates_.assign(set.begin(), set.end());
    began_.clear();
    ended_.clear();
    std::ranges::set_difference(candidates_, before, std::back_inserter(began_));
    std::ranges::set_difference(before, candidates_, std::back_inserter(ended_));
    for (const Pair& pair : began_) stamps_[pair.a] = stamp_;
  }

  void move_some() {
    ++stamp_;
    for (std::size_t i = 0; i < boxes_.size(); i += 4) {
      boxes_[i] = cube_in(random_, 6, 13);
      stamps_[i] = stamp_;
    }
  }

  void expect_truth(const PairChanges& changes, const std::vector<Pair>& before) {
    std::vector<Pair> truth, began, ended;
    for (const Pair& pair : candidates_) {
      if (overlap(boxes_[pair.a], boxes_[pair.b])) truth.push_back(pair);
    }
    std::ranges::set_difference(truth, before, std::back_inserter(began));
    std::ranges::set_difference(before, truth, std::back_inserter(ended));
    EXPECT_TRUE(std::ranges::equal(list_.pairs(), truth));
    EXPECT_TRUE(std::ranges::equal(changes.began, began));
    EXPECT_TRUE(std::ranges::equal(changes.ended, ended));
    ASSERT_GT(truth.size(), 10U);
  }

  std::vector<Pair> pairs() const { return {list_.pairs().begin(), list_.pairs().end()}; }

  contract::Random random_{2};
  Pool pool_;
  std::vector<Aabb> boxes_;
  IdTable table_;
  std::vector<std::uint8_t> stamps_;
  std::uint8_t stamp_ = 1;
  std::vector<Pair> candidates_, began_, ended_;
  OverlapList list_;
};

TEST_P(OverlapListTest, TellsWhatBeganAndEndedWhicheverWayItIsTested) {
  move_some();
  expect_truth(list_.renew(pool_, candidates_, {boxes_.data(), table_}, kAny), {});
  for (int round = 0; round < 60; ++round) {
    const std::vector<Pair> before = pairs();
    move_some();
    change_candidates(random_.below(3) * 20);
    const TestedBoxes all{boxes_.data(), table_};
    const TestedBoxes fresh{boxes_.data(), table_, stamps_.data(), stamp_};
    if (round % 3 == 0) {
      expect_truth(list_.renew(pool_, candidates_, all, kAny), before);
    } else {
      expect_truth(list_.refresh(pool_, candidates_, {began_, ended_}, round % 3 == 1 ? all : fresh, kAny),
                   before);
    }
  }
}

TEST_P(OverlapListTest, StaysAsItWasWhenThereWouldBeTooMany) {
  list_.renew(pool_, candidates_, {boxes_.data(), table_}, kAny);
  const std::vector<Pair> before = pairs();
  move_some();
  EXPECT_THROW(list_.renew(pool_, candidates_, {boxes_.data(), table_}, 3), TooManyPairs);
  EXPECT_THROW(list_.refresh(pool_, candidates_, {}, {boxes_.data(), table_}, 3), TooManyPairs);
  EXPECT_EQ(pairs(), before);
}

INSTANTIATE_TEST_SUITE_P(Workers, OverlapListTest, testing::Values(1U, 3U));

}  // namespace
}  // namespace cellsweep::stream
