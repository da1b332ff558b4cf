#include "cellsweep/pair_history.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <vector>

#include "base/memory/starved.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;

using Pairs = std::vector<Pair>;

constexpr std::size_t kPlenty = 1'000'000;

Status record(PairHistory& history, std::uint64_t number, const Pairs& began, const Pairs& ended) {
  return history.record(number, {began, ended});
}

/// Update 4: 1 2 and 3 4 begin; 5: 1 2 ends, 5 6 begins; 6: nothing; 7: 1 2 begins, 5 6 ends; 8: 3 4 anew.
PairHistory make_history(std::size_t most_pairs = kPlenty) {
  PairHistory history(most_pairs);
  EXPECT_TRUE(record(history, 4, {{1, 2}, {3, 4}}, {}).ok());
  EXPECT_TRUE(record(history, 5, {{5, 6}}, {{1, 2}}).ok());
  EXPECT_TRUE(record(history, 6, {}, {}).ok());
  EXPECT_TRUE(record(history, 7, {{1, 2}}, {{5, 6}}).ok());
  EXPECT_TRUE(record(history, 8, {{3, 4}}, {{3, 4}}).ok());
  return history;
}

void expect_since(PairHistory& history, std::uint64_t number, const Pairs& began, const Pairs& ended) {
  const auto changes = history.since(number);
  ASSERT_TRUE(changes.ok()) << changes.status().message;
  EXPECT_THAT(changes->began, ElementsAreArray(began)) << "since " << number;
  EXPECT_THAT(changes->ended, ElementsAreArray(ended)) << "since " << number;
}

TEST(PairHistory, SaysWhatChangedSinceAnyUpdate) {
  PairHistory history = make_history();
  expect_since(history, 3, {{1, 2}, {3, 4}}, {});
  expect_since(history, 4, {{1, 2}, {3, 4}}, {{1, 2}, {3, 4}});
  expect_since(history, 5, {{1, 2}, {3, 4}}, {{3, 4}, {5, 6}});
  expect_since(history, 6, {{1, 2}, {3, 4}}, {{3, 4}, {5, 6}});
  expect_since(history, 7, {{3, 4}}, {{3, 4}});
  expect_since(history, 8, {}, {});
}

TEST(PairHistory, MayBeginWithAnyUpdate) {
  PairHistory history(kPlenty);
  ASSERT_TRUE(record(history, 0, {{1, 2}}, {}).ok());
  expect_since(history, 0, {}, {});
  ASSERT_TRUE(record(history, 1, {{3, 4}}, {{1, 2}}).ok());
  expect_since(history, 0, {{3, 4}}, {{1, 2}});
}

TEST(PairHistory, RefusesAnUpdateThatDoesNotFollow) {
  PairHistory history = make_history();
  for (const std::uint64_t number : {0, 7, 8, 10}) {
    const Status status = record(history, number, {{7, 8}}, {});
    EXPECT_EQ(status.code, StatusCode::bad_input);
    EXPECT_EQ(status.number, number);
    EXPECT_EQ(status.limit, 9U);
    EXPECT_THAT(status.message, HasSubstr("after update 8"));
  }
  expect_since(history, 7, {{3, 4}}, {{3, 4}});
  EXPECT_TRUE(record(history, 9, {}, {}).ok());
}

TEST(PairHistory, RefusesWhatIsNotRecordedYet) {
  PairHistory empty(kPlenty);
  EXPECT_THAT(empty.since(0).status().message, HasSubstr("none is recorded"));
  PairHistory history = make_history();
  const Status status = history.since(9).status();
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_EQ(status.number, 9U);
  EXPECT_EQ(status.limit, 8U);
}

void expect_forgotten(PairHistory& history, std::uint64_t number, std::uint64_t oldest) {
  const Status status = history.since(number).status();
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.number, number);
  EXPECT_EQ(status.limit, oldest);
  EXPECT_EQ(status.setting, "most_pairs");
  EXPECT_TRUE(history.since(oldest).ok());
}

TEST(PairHistory, ForgetsTheOldestUpdatesForWantOfRoomAndNamesTheOldestThatIsThere) {
  PairHistory all = make_history();
  expect_forgotten(all, 2, 3);
  PairHistory eight = make_history(8);
  expect_forgotten(eight, 2, 3);
  PairHistory seven = make_history(7);
  expect_forgotten(seven, 3, 4);
  PairHistory four = make_history(4);
  expect_forgotten(four, 4, 5);
  expect_since(four, 6, {{1, 2}, {3, 4}}, {{3, 4}, {5, 6}});
  PairHistory two = make_history(2);
  expect_forgotten(two, 6, 7);
  PairHistory one = make_history(1);
  expect_forgotten(one, 7, 8);
  PairHistory none = make_history(0);
  expect_forgotten(none, 7, 8);
  EXPECT_TRUE(record(none, 9, {}, {}).ok());
  expect_since(none, 8, {}, {});
}

TEST(PairHistory, OneUpdateThatIsTooLargeIsForgottenWithAllBefore) {
  PairHistory history(3);
  ASSERT_TRUE(record(history, 1, {{1, 2}}, {}).ok());
  ASSERT_TRUE(record(history, 2, {{1, 3}, {1, 4}}, {{1, 2}, {2, 3}}).ok());
  expect_forgotten(history, 1, 2);
  expect_since(history, 2, {}, {});
  ASSERT_TRUE(record(history, 3, {{5, 6}}, {}).ok());
  expect_since(history, 2, {{5, 6}}, {});
}

TEST(PairHistory, WhatWasHandedOutStaysWhenACallFails) {
  PairHistory history = make_history();
  const auto changes = history.since(5);
  EXPECT_TRUE(fails_at(1, [&] { static_cast<void>(history.since(3)); }));
  EXPECT_FALSE(history.since(2).ok());
  EXPECT_THAT(changes->began, ElementsAre(Pair{1, 2}, Pair{3, 4}));
  EXPECT_THAT(changes->ended, ElementsAre(Pair{3, 4}, Pair{5, 6}));
}

TEST(PairHistoryWithoutMemory, IsAsItWasBeforeAnUpdateAndBeforeAQuestion) {
  Pairs many;
  for (BodyId id = 10; id < 5000; ++id) many.push_back({id, id + 1});
  const auto make = [] { return make_history(6000); };
  const auto is_kept = [](PairHistory& history) {
    expect_forgotten(history, 2, 3);
    expect_since(history, 5, {{1, 2}, {3, 4}}, {{3, 4}, {5, 6}});
    expect_since(history, 8, {}, {});
  };
  const auto is_done = [&](PairHistory& history) { expect_since(history, 8, many, {}); };
  const auto add = [&](PairHistory& history) { ASSERT_TRUE(record(history, 9, many, {}).ok()); };
  EXPECT_GE(starve(make, add, is_kept, is_done), 1U);
  const auto ask = [](PairHistory& history) { EXPECT_TRUE(history.since(4).ok()); };
  EXPECT_EQ(starve(make, ask, is_kept, is_kept), 3U);
}

/// A world that is changed at random, each update's pairs with the bodies' lives, and a history of it.
class RandomHistory {
 public:
  RandomHistory(std::uint64_t seed, std::size_t bodies, std::size_t most_pairs)
      : random_(seed), bodies_(bodies), history_(most_pairs) {
    overlaps_.emplace_back();
  }

  void step() {
    for (std::size_t changes = random_.below(bodies_.size() / 2 + 1); changes > 0; --changes) change_one();
    const auto changes = broadphase_.update();
    ASSERT_TRUE(changes.ok());
    ASSERT_TRUE(history_.record(broadphase_.statistics().updates, *changes).ok());
    overlaps_.push_back(overlaps_now());
  }

  /// Compares the answer for each update with the sets, as far as there is one; how many there were.
  std::size_t expect_right() {
    std::size_t answered = 0;
    Overlaps kept = overlaps_.back();
    for (std::size_t number = overlaps_.size(); number-- > 0;) {
      std::erase_if(kept, [&](const Overlap& one) { return !overlaps_[number].contains(one); });
      const auto changes = history_.since(number);
      if (!changes) {
        EXPECT_EQ(changes.status().code, StatusCode::capacity);
        EXPECT_EQ(changes.status().limit, number + 1);
        return answered;
      }
      EXPECT_THAT(changes->began, ElementsAreArray(pairs_without(overlaps_.back(), kept))) << number;
      EXPECT_THAT(changes->ended, ElementsAreArray(pairs_without(overlaps_[number], kept))) << number;
      if (testing::Test::HasFailure()) return answered;
      ++answered;
    }
    return answered;
  }

 private:
  struct Body {
    bool is_there = false;
    int life = 0;
    Aabb box{};
    BodyFilter filter{};
  };
  using Overlap = std::tuple<Pair, int, int>;  // with the lives of its bodies
  using Overlaps = std::set<Overlap>;

  void change_one() {
    const auto id = static_cast<BodyId>(random_.below(bodies_.size()));
    Body& body = bodies_[id];
    const bool goes = body.is_there && random_.one_in(4);
    if (goes) {
      ASSERT_TRUE(broadphase_.remove(id).ok());
      body = {false, body.life + 1};
      if (random_.one_in(2)) return;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      body.box.min[axis] = static_cast<float>(random_.whole(0, 4));
      body.box.max[axis] = body.box.min[axis] + static_cast<float>(random_.whole(0, 2));
    }
    ASSERT_TRUE((body.is_there ? broadphase_.move(id, body.box) : broadphase_.insert(id, body.box)).ok());
    body.is_there = true;
    if (!random_.one_in(5)) return;
    body.filter.category = 1 + static_cast<std::uint32_t>(random_.below(3));
    body.filter.mask = 1 + static_cast<std::uint32_t>(random_.below(3));
    ASSERT_TRUE(broadphase_.set_filter(id, body.filter).ok());
  }

  Overlaps overlaps_now() const {
    Overlaps overlaps;
    for (BodyId b = 0; b < bodies_.size(); ++b) {
      for (BodyId a = 0; a < b; ++a) {
        const Body& one = bodies_[a];
        const Body& other = bodies_[b];
        if (one.is_there && other.is_there && overlap(one.box, other.box) &&
            may_pair(one.filter, other.filter))
          overlaps.insert({{a, b}, one.life, other.life});
      }
    }
    return overlaps;
  }

  static Pairs pairs_without(const Overlaps& all, const Overlaps& kept) {
    Pairs pairs;
    for (const Overlap& one : all) {
      if (!kept.contains(one)) pairs.push_back(std::get<Pair>(one));
    }
    return pairs;
  }

  Random random_;
  std::vector<Body> bodies_;
  Broadphase broadphase_;
  PairHistory history_;
  std::vector<Overlaps> overlaps_;  // after each update; before the first there are none
};

TEST(PairHistory, EqualsSetsThatAreKeptForEveryUpdateOfARandomWorld) {
  for (const std::size_t bodies : {2, 7, 40}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      RandomHistory world(seed, bodies, kPlenty);
      for (int step = 0; step < 25; ++step) {
        ASSERT_NO_FATAL_FAILURE(world.step());
        if (step % 6 == 0) world.expect_right();
        if (testing::Test::HasFailure()) return;
      }
      EXPECT_EQ(world.expect_right(), 26U);
    }
  }
}

TEST(PairHistory, IsRightAboutWhatItHasNotForgottenOfARandomWorld) {
  std::size_t answered = 0;
  for (const std::size_t most_pairs : {0, 1, 30, 200, 1000}) {
    RandomHistory world(most_pairs, 30, most_pairs);
    for (int step = 0; step < 60; ++step) {
      ASSERT_NO_FATAL_FAILURE(world.step());
      answered += world.expect_right();
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(answered, 5U * 60U) << "more than the last update each time";
}

}  // namespace
}  // namespace cellsweep
