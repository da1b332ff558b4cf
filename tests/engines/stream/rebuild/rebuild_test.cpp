/// @file
/// All bodies move: engine `stream` finds everything anew a part at a time, and is exact whatever happens in
/// between.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/memory/starved.h"
#include "base/threads/numbers_of_workers.h"
#include "engines/stream/courses.h"
#include "engines/stream/kernels/kernel.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using contract::Random;

constexpr std::size_t kRebuiltBodies = 3000 / kScale;

void update_all(Broadphase& engine, const Courses& courses) {
  move_every(engine, courses.boxes(), 1);
  ASSERT_TRUE(engine.update().ok());
}

/// A cube of 1 among others that stand `gap` from each other, `side` on each axis.
Aabb place(std::size_t i, std::size_t side, float gap, float at) {
  Aabb box;
  const std::size_t steps[] = {i % side, i / side % side, i / side / side};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = at + gap * static_cast<float>(steps[axis]);
    box.max[axis] = box.min[axis] + 1;
  }
  return box;
}

class RebuildTest : public testing::TestWithParam<unsigned> {
 protected:
  // With a margin small worlds have fat boxes, too.
  Broadphase engine_of(const Courses& courses) {
    return engine_with(courses.boxes(), {.threads = GetParam(), .margin = 1e-6F});
  }
};

TEST_P(RebuildTest, IsDoneAPartAtATimeWhileAllKeepTheirCourse) {
  Courses courses(3000, 1);
  Broadphase engine = engine_of(courses);
  for (int frame = 0; frame < 60; ++frame) {
    update_all(engine, courses);
    if (frame % kScale == 0) {
      ASSERT_TRUE(is_exact(engine, courses.boxes())) << "frame " << frame;
    }
    courses.go_on();
  }
  EXPECT_LE(counter(engine, "full updates"), 4U) << "bodies that have just begun to move";
}

// The bodies are in the first corner of their world: none is in the last one.
TEST_P(RebuildTest, IsDoneInTimeWhereTheLastCellsAreEmpty) {
  constexpr std::size_t kMany = 18'000;
  Courses courses(kMany, 9);
  const float edge = 2 * std::cbrt(static_cast<float>(kMany));
  std::vector<Aabb> boxes;
  for (const Aabb& box : courses.boxes()) {
    if (box.min[0] + box.min[1] + box.min[2] < edge) boxes.push_back(box);
  }
  std::vector<std::array<float, 3>> steps(boxes.size());
  for (auto& step : steps) {
    for (float& on_axis : step) on_axis = courses.random().between(-0.04F, 0.04F);
  }
  Broadphase engine = engine_with(boxes, {.threads = GetParam(), .margin = 1e-6F});
  for (int frame = 0; frame < 60; ++frame) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        boxes[i].min[axis] += steps[i][axis];
        boxes[i].max[axis] += steps[i][axis];
      }
    }
    move_every(engine, boxes, 1);
    ASSERT_TRUE(engine.update().ok());
  }
  EXPECT_TRUE(is_exact(engine, boxes));
  EXPECT_LE(counter(engine, "full updates"), 4U) << "bodies that have just begun to move";
}

TEST_P(RebuildTest, IsNotBegunWhereBodiesCreepAndFatBoxesLast) {
  Courses courses(kRebuiltBodies, 6);
  Broadphase engine = engine_of(courses);
  std::vector<Aabb> boxes = courses.boxes();
  for (int frame = 0; frame < 40; ++frame) {
    for (Aabb& box : boxes) box.min[0] += 1e-4F, box.max[0] += 1e-4F;
    move_every(engine, boxes, 1);
    ASSERT_TRUE(engine.update().ok());
  }
  EXPECT_TRUE(is_exact(engine, boxes));
  const std::uint64_t at_once = counter(engine, "full updates") * kRebuiltBodies;
  EXPECT_LT(counter(engine, "fat boxes put into cells"), at_once + kRebuiltBodies / 10)
      << "or a part at a time";
}

// All fat boxes are as old, and are left within few updates after many in which hardly anybody did.
TEST_P(RebuildTest, IsDoneInTimeWhereBodiesCreep) {
  constexpr std::size_t kMany = 3000;
  for (const float speed : {1.0F / 300, 1.0F / 1000, 1.0F / 2000}) {
    Courses courses(kMany, 3);
    Broadphase engine = engine_of(courses);
    std::vector<Aabb> boxes = courses.boxes();
    Random random(8);
    std::vector<std::array<float, 3>> steps(kMany);
    for (std::size_t i = 0; i < kMany; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        steps[i][axis] = random.between(-speed, speed) * (boxes[i].max[axis] - boxes[i].min[axis]);
    }
    std::uint64_t full = 0;
    for (int frame = 0; frame < 200; ++frame) {
      for (std::size_t i = 0; i < kMany; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          boxes[i].min[axis] += steps[i][axis];
          boxes[i].max[axis] += steps[i][axis];
        }
      }
      move_every(engine, boxes, 1);
      ASSERT_TRUE(engine.update().ok());
      if (frame == 60) full = counter(engine, "full updates");
    }
    EXPECT_TRUE(is_exact(engine, boxes));
    EXPECT_LE(counter(engine, "full updates"), full + 1) << "at speed " << speed;
  }
}

// Of the first updates some find everything anew at once.
TEST_P(RebuildTest, LeavesNoUpdateWithMuchMoreWorkThanOthers) {
  Courses courses(8000, 2);
  Broadphase engine = engine_of(courses);
  Work at_once;
  for (int frame = 0; frame < 80; ++frame) {
    const Work before = engine.statistics().work;
    update_all(engine, courses);
    courses.go_on();
    const Work work = engine.statistics().work - before;
    if (frame < 24) {
      at_once.boxes_compared = std::max(at_once.boxes_compared, work.boxes_compared);
    } else {
      EXPECT_LT(4 * work.boxes_compared, 3 * at_once.boxes_compared) << "frame " << frame;
    }
  }
}

// A fat box is put into cells once when it is prepared, and again where a body leaves the next one before its
// time.
TEST_P(RebuildTest, PreparesTheNextFatBoxOfEachBodyOnce) {
  constexpr int kFirst = 30, kFrames = 80;
  Courses courses(3000, 7);
  Broadphase engine = engine_of(courses);
  std::uint64_t put_before = 0, full_before = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    if (frame == kFirst) {
      put_before = counter(engine, "fat boxes put into cells");
      full_before = counter(engine, "full updates");
    }
    update_all(engine, courses);
    courses.go_on();
  }
  EXPECT_EQ(counter(engine, "full updates"), full_before);
  const auto put = static_cast<double>(counter(engine, "fat boxes put into cells") - put_before);
  EXPECT_LT(put / 3000, 1.0 * (kFrames - kFirst) / 4);
}

// They leap, turn and stop, some are taken out and put in again, static for a while.
TEST_P(RebuildTest, IsExactWhateverBodiesDoInTheMeantime) {
  for (const std::size_t quiet : {1, 3, 5, 11}) {
    Courses courses(kRebuiltBodies, quiet);
    Broadphase engine = engine_of(courses);
    Random& random = courses.random();
    for (std::size_t frame = 0; frame < 70; ++frame) {
      courses.go_on();
      for (std::size_t i = 0; i < kRebuiltBodies / 100; ++i) courses.turn(random.below(kRebuiltBodies));
      courses.leap(random.below(kRebuiltBodies));
      if (frame % quiet == 0 && frame > 20) {
        const auto body = static_cast<BodyId>(random.below(kRebuiltBodies));
        ASSERT_TRUE(engine.remove({&body, 1}).ok());
        if (frame % 2 == 0) {
          ASSERT_TRUE(engine.update().ok());
        }
        ASSERT_TRUE(engine.insert({&body, 1}, {&courses.boxes()[body], 1}).ok());
      }
      const std::size_t every = frame % 17 == 16 ? 3 : 1;
      if (every == 1) {
        update_all(engine, courses);
        ASSERT_TRUE(is_exact(engine, courses.boxes())) << "frame " << frame << ", quiet " << quiet;
      } else {
        move_every(engine, courses.boxes(), every);
        ASSERT_TRUE(engine.update().ok());
      }
    }
  }
}

TEST_P(RebuildTest, TellsWhatIsStaticFromWhatIsNot) {
  Courses courses(kRebuiltBodies, 6);
  Broadphase engine = engine_of(courses);
  std::vector<BodyFilter> filters(kRebuiltBodies);
  for (int frame = 0; frame < 40; ++frame) {
    if (frame % 13 == 12) {
      for (BodyFilter& filter : filters) filter.is_static = courses.random().one_in(3);
      ASSERT_TRUE(engine.set_filters(ids_below(kRebuiltBodies), filters).ok());
    }
    courses.go_on();
    update_all(engine, courses);
    std::vector<Pair> pairs = pairs_among(courses.boxes());
    std::erase_if(pairs,
                  [&](const Pair& pair) { return filters[pair.a].is_static && filters[pair.b].is_static; });
    ASSERT_TRUE(std::ranges::equal(engine.pairs(), pairs)) << "frame " << frame;
  }
}

// Bodies leap so near to each other that their fat boxes have more pairs than there may be, but not the
// boxes. In one of these frames that is when the next fat boxes come into use.
TEST_P(RebuildTest, IsGivenUpWhereNextFatBoxesHaveTooManyPairs) {
  constexpr std::size_t kMany = 3000, kLeaping = 250;
  for (int leap = 9; leap < 26; ++leap) {
    std::vector<Aabb> boxes(kMany);
    for (std::size_t i = 0; i < kMany; ++i) boxes[i] = place(i, 15, 5, 0);
    boxes[kMany - 1] = boxes[kMany - 2];
    Broadphase engine = engine_with(boxes, {.threads = GetParam(), .margin = 0.5F, .max_pairs = 10});
    for (int frame = 0; frame < leap + 12; ++frame) {
      for (Aabb& box : boxes) {
        box.min[0] += 0.1F;
        box.max[0] += 0.1F;
      }
      if (frame == leap) {
        for (std::size_t i = 0; i < kLeaping; ++i) boxes[i] = place(i, 7, 1.5F, 200);
      }
      move_every(engine, boxes, 1);
      ASSERT_TRUE(engine.update().ok());
      ASSERT_EQ(engine.pairs().size(), 1U) << "leap " << leap << ", frame " << frame;
    }
  }
}

// Some turn towards each other while the next fat boxes are prepared, and turn back before they meet: where
// they would be by then they have more pairs than there may be.
TEST_P(RebuildTest, IsGivenUpWhereBodiesThatTurnedWouldHaveTooManyPairs) {
  constexpr std::size_t kMany = 3000, kSide = 5, kTurning = kSide * kSide * kSide;
  constexpr float kGap = 1.9F;
  for (int turn = 12; turn < 30; ++turn) {
    std::vector<Aabb> boxes(kMany);
    for (std::size_t i = 0; i < kMany; ++i) boxes[i] = place(i, 15, 5, 0);
    for (std::size_t i = 0; i < kTurning; ++i) boxes[i] = place(i, kSide, kGap, 200);
    boxes[kMany - 1] = boxes[kMany - 2];
    Broadphase engine = engine_with(boxes, {.threads = GetParam(), .margin = 0.01F, .max_pairs = 10});
    const auto go_on = [&](float inwards) {
      for (std::size_t i = 0; i < kMany; ++i) {
        const std::size_t at[] = {i % kSide, i / kSide % kSide, i / kSide / kSide};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          float step = axis == 0 ? 0.1F : 0;
          if (i < kTurning)
            step += inwards * kGap * (static_cast<float>(kSide / 2) - static_cast<float>(at[axis]));
          boxes[i].min[axis] += step;
          boxes[i].max[axis] += step;
        }
      }
      move_every(engine, boxes, 1);
      ASSERT_TRUE(engine.update().ok());
      ASSERT_EQ(engine.pairs().size(), 1U) << "turn " << turn;
    };
    for (int frame = 0; frame < turn; ++frame) go_on(0);
    go_on(0.2F);
    go_on(-0.2F);
    for (int frame = 0; frame < 10; ++frame) go_on(0);
  }
}

TEST_P(RebuildTest, GivesItsMemoryBackWhenMostBodiesStay) {
  constexpr std::size_t kMany = 3000;
  Courses courses(kMany, 3);
  Broadphase engine = engine_of(courses);
  for (int frame = 0; frame < 40; ++frame) {
    update_all(engine, courses);
    courses.go_on();
  }
  const std::uint64_t moving = engine.statistics().bytes;
  ASSERT_TRUE(engine.move(7, courses.boxes()[8]).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_LT(engine.statistics().bytes, moving - kMany * sizeof(Aabb));
}

TEST_P(RebuildTest, IsExactWhereverMemoryFails) {
  constexpr std::size_t kFew = 60;
  bool failed = true;
  std::uint64_t n = 1;
  for (; failed && !HasFailure(); ++n) {
    Courses courses(kFew, 4);
    Broadphase engine = engine_of(courses);
    failed = false;
    for (int frame = 0; frame < 24; ++frame) {
      courses.go_on();
      move_every(engine, courses.boxes(), 1);
      const auto update = [&] { ASSERT_TRUE(engine.update().ok()); };
      if (frame >= 8 && !failed) {
        const std::vector<Pair> before(engine.pairs().begin(), engine.pairs().end());
        failed = fails_at(n, update);
        if (!failed) continue;
        EXPECT_TRUE(std::ranges::equal(engine.pairs(), before)) << "nothing has changed";
      }
      update();
      ASSERT_TRUE(is_exact(engine, courses.boxes())) << "place " << n << ", frame " << frame;
    }
  }
  const bool sweeps = find_kernels(VectorIsa::best)->sweep != nullptr;  // which asks for memory, too
  EXPECT_GT(n, sweeps ? 5U : 3U) << "memory is asked for in fewer places than there are";
}

INSTANTIATE_TEST_SUITE_P(Threads, RebuildTest, numbers_of_workers());

}  // namespace
}  // namespace cellsweep::stream
