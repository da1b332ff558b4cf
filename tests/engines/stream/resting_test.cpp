/// @file
/// The same few bodies move for many updates: engine `stream` walks their candidates alone, and is exact when
/// others begin to move, come and go.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "base/memory/starved.h"
#include "base/threads/numbers_of_workers.h"
#include "engines/stream/courses.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using contract::Random;

/// Bodies of which each tenth moves.
class RestingTest : public testing::TestWithParam<unsigned> {
 protected:
  static constexpr std::size_t kEvery = 10;

  void begin(std::size_t bodies, std::uint64_t seed, float margin = 1e-6F) {
    courses_ = std::make_unique<Courses>(bodies, seed);
    boxes_ = courses_->boxes();
    filters_.assign(bodies, {});
    engine_ = engine_with(boxes_, {.threads = GetParam(), .margin = margin});
    ASSERT_TRUE(engine_.update().ok());
  }

  void move(std::size_t body) {
    boxes_[body] = courses_->boxes()[body];
    ASSERT_TRUE(engine_.move(static_cast<BodyId>(body), boxes_[body]).ok());
  }
  void move_those_that_do() {
    courses_->go_on();
    for (std::size_t body = 0; body < boxes_.size(); body += kEvery) move(body);
  }
  void go_on(int updates) {
    for (int update = 0; update < updates; ++update) {
      move_those_that_do();
      ASSERT_TRUE(engine_.update().ok());
    }
  }
  /// Takes one out and puts it in somewhere else, in the same update or in two.
  void replace(std::size_t body, bool at_once) {
    const auto id = static_cast<BodyId>(body);
    ASSERT_TRUE(engine_.remove(id).ok());
    if (!at_once) {
      ASSERT_TRUE(engine_.update().ok());
    }
    courses_->leap(body);
    boxes_[body] = courses_->boxes()[body];
    ASSERT_TRUE(engine_.insert({&id, 1}, {&boxes_[body], 1}).ok());
    filters_[body] = {};
  }

  testing::AssertionResult are_pairs_exact() const {
    std::vector<Pair> pairs = pairs_among(boxes_);
    std::erase_if(pairs,
                  [&](const Pair& pair) { return filters_[pair.a].is_static && filters_[pair.b].is_static; });
    if (std::ranges::equal(engine_.pairs(), pairs)) return testing::AssertionSuccess();
    return testing::AssertionFailure() << engine_.pairs().size() << " pairs instead of " << pairs.size();
  }

  std::unique_ptr<Courses> courses_;
  std::vector<Aabb> boxes_;
  std::vector<BodyFilter> filters_;
  Broadphase engine_;
};

// Nobody leaves a fat box, and each update compares the candidates that it walks.
TEST_P(RestingTest, CandidatesOfThoseThatRestAreNotWalked) {
  begin(3000, 1, 0.1F);
  const auto compared_by_update = [&](float by) {
    for (std::size_t body = 0; body < boxes_.size(); body += kEvery) {
      boxes_[body].min[1] += by;
      boxes_[body].max[1] += by;
      EXPECT_TRUE(engine_.move(static_cast<BodyId>(body), boxes_[body]).ok());
    }
    const Work before = engine_.statistics().work;
    EXPECT_TRUE(engine_.update().ok());
    return (engine_.statistics().work - before).boxes_compared;
  };
  compared_by_update(0.01F);
  compared_by_update(-0.01F);
  const std::uint64_t candidates = counter(engine_, "candidates");
  EXPECT_EQ(compared_by_update(0.01F), candidates);
  for (int update = 0; update < 10; ++update) compared_by_update(update % 2 == 0 ? -0.01F : 0.01F);
  EXPECT_LT(compared_by_update(-0.01F), candidates / 2);
  EXPECT_EQ(counter(engine_, "candidates"), candidates) << "they are there all the same";
  EXPECT_TRUE(are_pairs_exact());
}

TEST_P(RestingTest, IsExactWhoeverBeginsToMoveComesOrGoes) {
  constexpr std::size_t kBodies = 3000 / kScale;
  begin(kBodies, 2);
  Random& random = courses_->random();
  for (int round = 0; round < 24; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    go_on(10 + static_cast<int>(random.below(8)));
    ASSERT_TRUE(are_pairs_exact());
    move_those_that_do();
    const std::size_t body = random.below(kBodies / kEvery - 1) * kEvery + 7;
    if (round % 8 == 0) courses_->leap(body);
    if (round % 8 <= 1) move(body);
    if (round % 8 == 2) replace(body, true);
    if (round % 8 == 3) replace(body, false);
    if (round % 8 == 4) replace(body - 7, true);
    if (round % 8 == 5) {
      for (std::size_t i = 0; i < kBodies; ++i) move(i);
    }
    if (round % 8 == 6) {
      for (BodyFilter& filter : filters_) filter.is_static = random.one_in(3);
      ASSERT_TRUE(engine_.set_filters(ids_below(kBodies), filters_).ok());
    }
    ASSERT_TRUE(engine_.update().ok());
    ASSERT_TRUE(are_pairs_exact());
    if (round % 8 == 7) {
      for (int update = 0; update < 3; ++update) {
        courses_->go_on();
        move(7);
        ASSERT_TRUE(engine_.update().ok());
        ASSERT_TRUE(are_pairs_exact());
      }
    }
  }
}

// Those that rest leave no fat box: no candidate begins or ends.
TEST_P(RestingTest, IsExactWhenAllTrembleOnce) {
  begin(2000 / kScale, 6, 0.1F);
  const std::vector<Aabb> first = boxes_;
  const auto tremble = [&](float by) {
    for (std::size_t body = 0; body < boxes_.size(); ++body) {
      const float side = body % 2 == 0 ? by : -by;
      boxes_[body] = first[body];
      boxes_[body].min[1] += side;
      boxes_[body].max[1] += side;
    }
    ASSERT_TRUE(engine_.move(ids_below(boxes_.size()), boxes_).ok());
    ASSERT_TRUE(engine_.update().ok());
    ASSERT_TRUE(are_pairs_exact());
  };
  for (int round = 0; round < 4; ++round) {
    for (int update = 0; update < 3; ++update) tremble(update % 2 == 0 ? 0.04F : -0.04F);
    for (int update = 0; update < 40; ++update) {
      for (std::size_t body = 0; body < boxes_.size(); body += kEvery) {
        boxes_[body].min[1] += update % 2 == 0 ? 0.01F : -0.01F;
        boxes_[body].max[1] += update % 2 == 0 ? 0.01F : -0.01F;
        ASSERT_TRUE(engine_.move(static_cast<BodyId>(body), boxes_[body]).ok());
      }
      ASSERT_TRUE(engine_.update().ok());
    }
    ASSERT_TRUE(are_pairs_exact());
  }
}

// These are asked for in cells, whatever was walked before and is after that.
TEST_P(RestingTest, IsExactWhenVeryFewMoveInBetween) {
  for (int updates = 1; updates < 14; ++updates) {
    begin(3000 / kScale, 7);
    go_on(updates);
    for (int update = 0; update < 2; ++update) {
      courses_->go_on();
      for (std::size_t body = 6; body < 66; body += kEvery) move(body);
      ASSERT_TRUE(engine_.update().ok());
    }
    for (int update = 0; update < 3; ++update) {
      go_on(1);
      ASSERT_TRUE(are_pairs_exact()) << "after " << updates << " and " << update;
    }
    go_on(12);
    for (std::size_t body = 0; body < boxes_.size(); body += 3) move(body);
    ASSERT_TRUE(engine_.update().ok());
    ASSERT_TRUE(are_pairs_exact());
  }
}

TEST_P(RestingTest, IsExactWhenAllGo) {
  begin(600, 3);
  go_on(20);
  ASSERT_TRUE(engine_.remove(ids_below(600)).ok());
  const auto update = engine_.update();
  ASSERT_TRUE(update.ok());
  EXPECT_TRUE(std::ranges::equal(update->ended, pairs_among(boxes_)));
  EXPECT_TRUE(engine_.pairs().empty());
}

TEST_P(RestingTest, GivesItsMemoryBackWhenNobodyMoves) {
  begin(3000, 4);
  go_on(20);
  const std::uint64_t moving = engine_.statistics().bytes;
  for (int update = 0; update < 40; ++update) ASSERT_TRUE(engine_.update().ok());
  EXPECT_LE(engine_.statistics().bytes, moving);
  go_on(2);
  EXPECT_TRUE(are_pairs_exact());
}

// Where they are parted, reunited and parted again.
TEST_P(RestingTest, IsExactWhereverMemoryFails) {
  bool failed = true;
  std::uint64_t n = 1;
  for (; failed && !HasFailure(); ++n) {
    begin(100, 5);
    go_on(4);
    failed = false;
    for (int frame = 0; frame < 40; ++frame) {
      move_those_that_do();
      if (frame == 14) move(7);
      const auto update = [&] { ASSERT_TRUE(engine_.update().ok()); };
      if (!failed) {
        const std::vector<Pair> before(engine_.pairs().begin(), engine_.pairs().end());
        failed = fails_at(n, update);
        if (failed) {
          EXPECT_TRUE(std::ranges::equal(engine_.pairs(), before)) << "nothing has changed";
          update();
        }
      } else {
        update();
      }
      ASSERT_TRUE(are_pairs_exact()) << "place " << n << ", frame " << frame;
    }
  }
  EXPECT_GT(n, 3U);
}

INSTANTIATE_TEST_SUITE_P(Threads, RestingTest, numbers_of_workers());

}  // namespace
}  // namespace cellsweep::stream
