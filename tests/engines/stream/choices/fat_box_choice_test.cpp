/// @file
/// Worlds in which most bodies move: engine `stream` sweeps small ones in every update, unless bodies
/// tremble, and gives large ones fat boxes, unless these do not last.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "base/memory/starved.h"
#include "base/threads/thread_pool.h"
#include "engines/stream/choices/fat_box_choice.h"
#include "engines/stream/courses.h"
#include "engines/stream/kernels/kernel.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using contract::Random;

constexpr std::size_t kFewBodies = 500;
constexpr std::size_t kMoreBodies = 1500;  // too many to be swept from the first
constexpr std::size_t kManyBodies = 4000;

class WorldInMotion : public testing::Test {
 protected:
  explicit WorldInMotion(std::size_t bodies) : courses_(bodies, 1) { EXPECT_TRUE(engine_.update().ok()); }

  /// Moves all bodies that `every` divides; expects the pairs of brute force.
  void update_with(const std::vector<Aabb>& boxes, std::size_t every = 1) {
    move_every(engine_, boxes, every);
    for (std::size_t i = 0; i < boxes.size(); i += every) shown_[i] = boxes[i];
    const std::uint64_t before = full_updates();
    ASSERT_TRUE(engine_.update().ok());
    was_full_ = full_updates() > before;
    ASSERT_TRUE(is_exact(engine_, shown_));
  }
  void go_on(std::size_t every = 1) {
    courses_.go_on();
    update_with(courses_.boxes(), every);
  }
  void tremble(std::uint64_t frame) {
    std::vector<Aabb> boxes = courses_.boxes();
    shake(boxes, 0.02F, frame);
    update_with(boxes);
  }
  /// By small steps, on each axis the other way in so many of ten, as in stacks that settle.
  void wander(std::vector<Aabb>& boxes, std::vector<float>& ways, float most, std::size_t turns) {
    Random& random = courses_.random();
    ways.resize(3 * boxes.size(), 1);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (random.below(10) < turns) ways[i] = -ways[i];
      const float step = ways[i] * random.between(0, most);
      boxes[i / 3].min[i % 3] += step;
      boxes[i / 3].max[i % 3] += step;
    }
    update_with(boxes);
  }
  std::uint64_t full_updates() const { return counter(engine_, "full updates"); }

  /// To and fro like those that tremble, but so far that fat boxes do not last.
  void shake_hard(std::uint64_t frame) {
    std::vector<Aabb> boxes = courses_.boxes();
    shake(boxes, 0.6F, frame);
    update_with(boxes);
  }
  bool has_fat_boxes() const { return counter(engine_, "candidates") > engine_.pairs().size(); }

  Courses courses_;
  Broadphase engine_ = engine_with(courses_.boxes());
  std::vector<Aabb> shown_ = courses_.boxes();
  bool was_full_ = false;  // the last update
};

class SmallWorldTest : public WorldInMotion {
 protected:
  SmallWorldTest() : WorldInMotion(kFewBodies) {}

  void SetUp() override {
    if (find_kernels(VectorIsa::best)->sweep == nullptr) GTEST_SKIP() << "nothing is swept on this processor";
  }
};

class LargeWorldTest : public WorldInMotion, public testing::WithParamInterface<std::size_t> {
 protected:
  LargeWorldTest() : WorldInMotion(GetParam()) {}
};

TEST_F(SmallWorldTest, IsSweptInEveryUpdateWhileBodiesKeepTheirCourse) {
  for (int frame = 0; frame < 100; ++frame) {
    ASSERT_NO_FATAL_FAILURE(go_on());
    EXPECT_TRUE(was_full_) << "frame " << frame;
  }
  EXPECT_EQ(counter(engine_, "boxes in cells"), 0U);
}

TEST_F(SmallWorldTest, HasFatBoxesWhileBodiesTremble) {
  std::uint64_t full = 0;
  for (std::uint64_t frame = 0; frame < 60; ++frame) {
    ASSERT_NO_FATAL_FAILURE(tremble(frame));
    if (frame >= 20) full += was_full_ ? 1 : 0;
  }
  EXPECT_EQ(full, 0U);
}

// As stacks do that come to rest: in one direction, and nobody leaves a fat box for long.
TEST_F(SmallWorldTest, HasFatBoxesWhileBodiesCreep) {
  std::vector<Aabb> boxes = courses_.boxes();
  std::uint64_t full = 0;
  for (std::uint64_t frame = 0; frame < 60; ++frame) {
    for (Aabb& box : boxes) box.min[0] += 1e-4F, box.max[0] += 1e-4F;
    ASSERT_NO_FATAL_FAILURE(update_with(boxes));
    if (frame >= 20) full += was_full_ ? 1 : 0;
  }
  EXPECT_EQ(full, 0U);
}

TEST_F(SmallWorldTest, IsSweptMostOfTheTimeWhereFatBoxesAreTriedAndDoNotLast) {
  std::size_t with_fat_boxes = 0;
  for (std::uint64_t frame = 0; frame < 200; ++frame) {
    ASSERT_NO_FATAL_FAILURE(shake_hard(frame));
    with_fat_boxes += has_fat_boxes() ? 1 : 0;
  }
  EXPECT_GT(with_fat_boxes, 0U);
  EXPECT_LT(with_fat_boxes, 60U);
}

TEST_F(SmallWorldTest, HasFatBoxesWhileFewMove) {
  for (int frame = 0; frame < 20; ++frame) ASSERT_NO_FATAL_FAILURE(go_on());
  for (int frame = 0; frame < 20; ++frame) {
    ASSERT_NO_FATAL_FAILURE(go_on(20));
    if (frame > 0) {
      EXPECT_FALSE(was_full_) << "frame " << frame;
    }
  }
}

TEST_F(SmallWorldTest, IsSweptAgainWhenBodiesThatTrembledSetOff) {
  for (std::uint64_t frame = 0; frame < 100; ++frame) ASSERT_NO_FATAL_FAILURE(tremble(frame));
  EXPECT_FALSE(was_full_);
  for (int frame = 0; frame < 80; ++frame) ASSERT_NO_FATAL_FAILURE(go_on());
  for (int frame = 0; frame < 40; ++frame) {
    ASSERT_NO_FATAL_FAILURE(go_on());
    EXPECT_TRUE(was_full_) << "frame " << frame;
  }
}

// Whatever is watched, or was learnt of where boxes are.
TEST_F(SmallWorldTest, IsExactWhateverBodiesDo) {
  Random& random = courses_.random();
  std::size_t swept = 0, others = 0;
  for (std::uint64_t phase = 0; phase < 60; ++phase) {
    const std::size_t doing = random.below(5);
    const std::size_t every = doing == 1 ? 2 + random.below(30) : 1;
    for (std::uint64_t frame = 0; frame < 3 + random.below(20); ++frame) {
      if (doing == 2) courses_.leap(random.below(kFewBodies));
      if (doing == 3) {
        const auto body = static_cast<BodyId>(random.below(kFewBodies));
        ASSERT_TRUE(engine_.remove({&body, 1}).ok());
        if (random.one_in(2)) {
          ASSERT_TRUE(engine_.update().ok());
        }
        ASSERT_TRUE(engine_.insert({&body, 1}, {&shown_[body], 1}).ok());
      }
      if (doing == 4) {
        ASSERT_NO_FATAL_FAILURE(tremble(frame));
      } else {
        ASSERT_NO_FATAL_FAILURE(go_on(every));
      }
      (was_full_ ? swept : others) += 1;
    }
  }
  EXPECT_GT(swept, 50U);
  EXPECT_GT(others, 50U);
}

TEST_F(SmallWorldTest, WithAMarginHasFatBoxesAtOnce) {
  Broadphase engine = engine_with(courses_.boxes(), {.margin = 0.5F});
  ASSERT_TRUE(engine.update().ok());
  for (int frame = 0; frame < 4; ++frame) {
    courses_.go_on();
    move_every(engine, courses_.boxes(), 1);
    ASSERT_TRUE(engine.update().ok());
    EXPECT_TRUE(is_exact(engine, courses_.boxes()));
  }
  EXPECT_GT(counter(engine, "in-place updates"), 0U);
}

TEST_P(LargeWorldTest, HasFatBoxesWhileBodiesKeepTheirCourse) {
  std::uint64_t full = 0;
  for (int frame = 0; frame < 60; ++frame) {
    ASSERT_NO_FATAL_FAILURE(go_on());
    EXPECT_TRUE(has_fat_boxes()) << "frame " << frame;
    full += was_full_ ? 1 : 0;
  }
  EXPECT_LT(full, 4U);
}

// It takes some updates until their fat boxes reach far enough to either side, and so many full ones.
TEST_P(LargeWorldTest, HasFatBoxesSoonWhereBodiesWanderOrCreep) {
  const auto full_updates_later = [&](float most, std::size_t turns) {
    std::vector<Aabb> boxes = shown_;
    std::vector<float> ways;
    std::uint64_t full = 0;
    for (int frame = 0; frame < 80 && !HasFatalFailure(); ++frame) {
      wander(boxes, ways, most, turns);
      full += frame >= 30 && was_full_ ? 1 : 0;
    }
    return full;
  };
  EXPECT_EQ(full_updates_later(0.003F, 3), 0U);
  engine_ = engine_with(shown_);
  ASSERT_TRUE(engine_.update().ok());
  EXPECT_EQ(full_updates_later(0.0005F, 1), 0U);
}

// Some leave theirs an update before the others, by rounding: without cells to put a few into, that is no
// reason to find everything anew for these alone.
TEST_P(LargeWorldTest, MakesThemAnewOnceWhereAllFlyOn) {
  std::vector<Aabb> boxes = courses_.boxes();
  std::vector<float> steps;
  for (std::size_t i = 0; i < 3 * boxes.size(); ++i)
    steps.push_back(courses_.random().one_in(2) ? 0.03F : -0.03F);
  std::uint64_t full = 0;
  for (int frame = 0; frame < 60; ++frame) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
      boxes[i / 3].min[i % 3] += steps[i];
      boxes[i / 3].max[i % 3] += steps[i];
    }
    ASSERT_NO_FATAL_FAILURE(update_with(boxes));
    full += was_full_ ? 1 : 0;
  }
  EXPECT_LT(full, 4U);
}

// Where each update makes them anew, they take more than to find everything.
TEST_P(LargeWorldTest, DoesWithoutFatBoxesThatDoNotLast) {
  for (std::uint64_t frame = 0; frame < 10; ++frame) ASSERT_NO_FATAL_FAILURE(shake_hard(frame));
  for (std::uint64_t frame = 10; frame < 60; ++frame) {
    ASSERT_NO_FATAL_FAILURE(shake_hard(frame));
    EXPECT_TRUE(was_full_) << "frame " << frame;
    EXPECT_FALSE(has_fat_boxes()) << "frame " << frame;
  }
}

// A few bodies tell, within some updates.
TEST_P(LargeWorldTest, HasFatBoxesAgainSoonAfterTheyWouldLast) {
  for (int time = 0; time < 3; ++time) {
    for (std::uint64_t frame = 0; frame < 20; ++frame) ASSERT_NO_FATAL_FAILURE(shake_hard(frame));
    EXPECT_FALSE(has_fat_boxes());
    for (int frame = 0; frame < 26; ++frame) {
      ASSERT_NO_FATAL_FAILURE(time == 1 ? tremble(static_cast<std::uint64_t>(frame)) : go_on());
    }
    for (int frame = 0; frame < 4; ++frame) {
      ASSERT_NO_FATAL_FAILURE(time == 1 ? tremble(static_cast<std::uint64_t>(frame)) : go_on());
      EXPECT_TRUE(has_fat_boxes()) << "time " << time << ", frame " << frame;
    }
  }
}

TEST_P(LargeWorldTest, HasFatBoxesAtOnceWhenFewMove) {
  for (std::uint64_t frame = 0; frame < 20; ++frame) ASSERT_NO_FATAL_FAILURE(shake_hard(frame));
  for (int frame = 0; frame < 10; ++frame) {
    ASSERT_NO_FATAL_FAILURE(go_on(20));
    if (frame > 1) {
      EXPECT_FALSE(was_full_) << "frame " << frame;
    }
  }
}

// Of those that have fat boxes on trial, some go, and others get their slots.
TEST_P(LargeWorldTest, IsExactWhileBodiesComeAndGo) {
  Random& random = courses_.random();
  for (std::uint64_t frame = 0; frame < 60; ++frame) {
    for (int turn = 0; turn < 40; ++turn) {
      const auto body = static_cast<BodyId>(random.below(GetParam()));
      ASSERT_TRUE(engine_.remove({&body, 1}).ok());
      if (turn == 20) {
        ASSERT_TRUE(engine_.update().ok());
      }
      ASSERT_TRUE(engine_.insert({&body, 1}, {&shown_[body], 1}).ok());
    }
    if (frame % 30 < 15) {
      ASSERT_NO_FATAL_FAILURE(shake_hard(frame));
    } else {
      ASSERT_NO_FATAL_FAILURE(go_on());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, LargeWorldTest, testing::Values(kMoreBodies, kManyBodies));

// They are swept where fat boxes do not last, if that is possible; more bodies come into cells.
TEST(WorldWithoutFatBoxes, IsSweptWhereItIsNotTooLarge) {
  const bool has_sweeps = find_kernels(VectorIsa::best)->sweep != nullptr;
  for (const std::size_t bodies : {kMoreBodies, kManyBodies}) {
    std::vector<Aabb> boxes = uniform_boxes(bodies, 3);
    const std::vector<Aabb> still = boxes;
    Broadphase engine = engine_with(still);
    for (std::uint64_t frame = 0; frame < 40; ++frame) {
      boxes = still;
      shake(boxes, 0.6F, frame);
      move_every(engine, boxes, 1);
      ASSERT_TRUE(engine.update().ok());
    }
    EXPECT_EQ(counter(engine, "boxes in cells") == 0, has_sweeps && bodies == kMoreBodies) << bodies;
  }
}

// In the updates in which fat boxes are given up, and their trial begins.
TEST(WorldWithoutFatBoxes, ChangesNothingWhereMemoryFails) {
  std::uint64_t places = 0;
  for (std::uint64_t before = 3; before < 9; ++before) {
    bool failed = true;
    for (std::uint64_t n = 1; failed && !testing::Test::HasFailure(); ++n) {
      const std::vector<Aabb> still = uniform_boxes(kManyBodies, 3);
      Broadphase engine = engine_with(still);
      std::vector<Aabb> shown;
      const auto shake_hard = [&](std::uint64_t frame) {
        shown = still;
        shake(shown, 0.6F, frame);
        move_every(engine, shown, 1);
      };
      const auto update = [&] { ASSERT_TRUE(engine.update().ok()); };
      update();
      for (std::uint64_t frame = 0; frame < before; ++frame) {
        shake_hard(frame);
        update();
      }
      const std::vector<Pair> pairs(engine.pairs().begin(), engine.pairs().end());
      shake_hard(before);
      failed = fails_at(n, update);
      if (failed) {
        ++places;
        EXPECT_TRUE(std::ranges::equal(engine.pairs(), pairs)) << "update " << before << ", place " << n;
        update();
      }
      EXPECT_TRUE(is_exact(engine, shown)) << "update " << before << ", place " << n;
    }
  }
  EXPECT_GE(places, 3U) << "memory is asked for in fewer places than there are";
}

/// What a world in which all bodies move says of its updates; a sweep may find all.
class ToldChoice {
 public:
  explicit ToldChoice(std::size_t bodies) : boxes_(uniform_boxes(bodies, 1)), moved_(bodies) {
    std::iota(moved_.begin(), moved_.end(), Slot{0});
  }

  /// An update begins, in which the first so many bodies move; whether it is to have fat boxes.
  bool has_fat_boxes(std::size_t movers) {
    BodyChanges changes{};
    changes.boxes = boxes_;
    changes.before = {boxes_};
    changes.moved = std::span(moved_).first(movers);
    changes.bodies = boxes_.size();
    return !choice_.begin_update(crew_, changes);
  }

  /// So many updates like this one, as long as there are fat boxes. How many there were.
  int updates_of(FatBoxWork work, int most) {
    work.bodies = boxes_.size();
    for (int update = 0; update < most; ++update) {
      if (!has_fat_boxes(moved_.size())) return update;
      choice_.note(work);
    }
    return most;
  }

 private:
  std::vector<Aabb> boxes_;
  std::vector<Slot> moved_;
  Crew crew_{std::make_shared<ThreadPool>(1), 1, Crew::Choice::given};
  FatBoxChoice choice_{true, true};
};

constexpr int kForLong = 40;

TEST(FatBoxChoice, WaitsForNobodyWherePairsChangeAndCandidatesAreMany) {
  for (const std::size_t bodies : {kMoreBodies, kManyBodies}) {
    const FatBoxWork falling = {
        .is_full = true, .candidates = 5 * bodies, .pairs = bodies, .changed_pairs = bodies / 16};
    EXPECT_LE(ToldChoice(bodies).updates_of(falling, kForLong), 3) << bodies;
    FatBoxWork at_rest = falling;
    at_rest.is_full = false;
    at_rest.changed_pairs = bodies / 100;
    EXPECT_EQ(ToldChoice(bodies).updates_of(at_rest, kForLong), kForLong) << bodies << ", refitted one day";
    FatBoxWork few = falling;
    few.is_full = false;
    few.candidates = bodies;
    EXPECT_EQ(ToldChoice(bodies).updates_of(few, kForLong), kForLong) << bodies;
  }
}

// In a crowd each that leaves its fat box is compared with many, and has many candidates.
TEST(FatBoxChoice, CountsComparisonsOfBodiesThatLeaveTheirFatBoxes) {
  FatBoxWork loose = {.placed = 60, .compared = 60 * 30, .candidates = kMoreBodies, .pairs = kMoreBodies / 2};
  EXPECT_EQ(ToldChoice(kMoreBodies).updates_of(loose, kForLong), kForLong);
  FatBoxWork crowd = loose;
  crowd.compared = 60 * 200;
  crowd.candidates = 4 * kMoreBodies;
  EXPECT_LE(ToldChoice(kMoreBodies).updates_of(crowd, kForLong), 8);
}

// Few that move have fat boxes in any case: what was held against them before all moved is forgotten.
TEST(FatBoxChoice, JudgesFatBoxesByWhatTheyDoAfterTheyWereGivenUp) {
  ToldChoice choice(kMoreBodies);
  const FatBoxWork lasting = {.candidates = kMoreBodies, .pairs = kMoreBodies};
  FatBoxWork costly = lasting;
  costly.placed = 3 * kMoreBodies / 10;  // 36 ns a body, and 29 without: not yet enough for a verdict
  constexpr int kUnjudged = tuning::kUpdatesJudged - 1;
  EXPECT_EQ(choice.updates_of(costly, kUnjudged), kUnjudged);
  FatBoxWork falling = lasting;
  falling.candidates = 6 * kMoreBodies;
  falling.changed_pairs = kMoreBodies;
  EXPECT_EQ(choice.updates_of(falling, kForLong), 1);
  EXPECT_TRUE(choice.has_fat_boxes(kMoreBodies / 100));
  EXPECT_EQ(choice.updates_of(lasting, kForLong), kForLong);
}

}  // namespace
}  // namespace cellsweep::stream
