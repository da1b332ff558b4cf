#include "engines/control/sort_and_test.h"

#include <gtest/gtest.h>

#include <vector>

namespace cellsweep::control {
namespace {

// Intervals on the x axis, entered in the order given, every pair in the map.
class OneAxis {
 public:
  explicit OneAxis(const std::vector<std::pair<float, float>>& intervals) {
    for (const auto& [low, high] : intervals) boxes_.push_back({{low, 0, 0}, {high, 0, 0}});
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      list_.push_back({static_cast<int>(i), &boxes_[i], &boxes_[i].min[0]});
      list_.push_back({static_cast<int>(i), &boxes_[i], &boxes_[i].max[0]});
      for (std::size_t other = 0; other < i; ++other)
        pairs_.add(static_cast<int>(i), static_cast<int>(other));
    }
  }

  std::uint64_t sort() { return sort_with(sort_and_test); }
  std::uint64_t sort_literally() { return sort_with(sort_and_test_literal); }
  void move(std::size_t body, float low, float high) { boxes_[body] = {{low, 0, 0}, {high, 0, 0}}; }
  bool overlap(int one, int other) { return pairs_.find(one, other).value[0]; }

  std::vector<int> owners() const {
    std::vector<int> result;
    for (const Endpoint& end : list_) result.push_back(end.ownerID);
    return result;
  }

 private:
  template <class Sort>
  std::uint64_t sort_with(Sort sort_function) {
    std::vector<PairInfo> changed;
    SortEvents events{&changed};
    sort_function(list_, 0, pairs_, events);
    return events.swaps;
  }

  std::vector<Aabb> boxes_;
  EndpointList list_;
  PairManager pairs_;
};

TEST(SortAndTest, SortsEndpointsByValue) {
  OneAxis axis({{4, 5}, {0, 1}, {2, 3}});
  axis.sort();
  EXPECT_EQ(axis.owners(), (std::vector<int>{1, 1, 2, 2, 0, 0}));
}

TEST(SortAndTest, SeesAnOverlapAndASeparation) {
  OneAxis axis({{0, 2}, {1, 3}, {5, 6}});
  axis.sort();
  EXPECT_TRUE(axis.overlap(0, 1));
  EXPECT_FALSE(axis.overlap(0, 2));
  axis.move(1, 2.5F, 5.5F);
  axis.sort();
  EXPECT_FALSE(axis.overlap(0, 1));
  EXPECT_TRUE(axis.overlap(1, 2));
}

TEST(SortAndTest, DoesNothingWhenNothingMoved) {
  OneAxis axis({{3, 8}, {1, 4}, {2, 2}, {2, 9}});
  EXPECT_GT(axis.sort(), 0U);
  EXPECT_EQ(axis.sort(), 0U);
}

TEST(SortAndTest, SwapsEachInvertedPairOfEndpointsOnce) {
  OneAxis axis({{6, 7}, {4, 5}, {2, 3}, {0, 1}});
  EXPECT_EQ(axis.sort(), 4U * 6U);
}

TEST(SortAndTest, SeesAnIntervalInsideAnotherWhicheverComesFirst) {
  OneAxis outer_first({{0, 9}, {3, 4}});
  OneAxis inner_first({{3, 4}, {0, 9}});
  outer_first.sort();
  inner_first.sort();
  EXPECT_TRUE(outer_first.overlap(0, 1));
  EXPECT_TRUE(inner_first.overlap(0, 1));
}

TEST(SortAndTest, SeesATouchWhicheverComesFirst) {
  OneAxis left_first({{0, 1}, {1, 2}});
  OneAxis right_first({{1, 2}, {0, 1}});
  left_first.sort();
  right_first.sort();
  EXPECT_TRUE(left_first.overlap(0, 1));
  EXPECT_TRUE(right_first.overlap(0, 1));
}

TEST(SortAndTest, SeesATouchBeginAndEndWhereNoValuesCross) {
  OneAxis axis({{0, 1}, {2, 3}});
  axis.sort();
  axis.move(1, 1, 3);
  axis.sort();
  EXPECT_TRUE(axis.overlap(0, 1));
  axis.move(1, 1.5F, 3);
  axis.sort();
  EXPECT_FALSE(axis.overlap(0, 1));
}

TEST(SortAndTest, LiteralMissesAnIntervalThatContainsTheMovedOne) {
  // The lower of the two swapped endpoints is body 1's maximum, and body 0 reaches past body 1 on both sides.
  OneAxis axis({{5, 9}, {20, 21}});
  axis.sort_literally();
  axis.move(1, 6, 7);
  axis.sort_literally();
  EXPECT_FALSE(axis.overlap(0, 1));
}

TEST(SortAndTest, LiteralMissesATouchThatBringsNoSwap) {
  OneAxis axis({{0, 1}, {1, 2}});
  EXPECT_EQ(axis.sort_literally(), 0U);
  EXPECT_FALSE(axis.overlap(0, 1));
}

}  // namespace
}  // namespace cellsweep::control
