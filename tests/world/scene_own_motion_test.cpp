#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cellsweep/world/scene.h"
#include "scene_probe.h"

namespace cellsweep {
namespace {

using test::frames_of;

std::vector<Aabb> copy(std::span<const Aabb> boxes) {
  return {boxes.begin(), boxes.end()};
}

float edge(const Aabb& box, std::size_t axis = 0) {
  return box.max[axis] - box.min[axis];
}

float way(const Aabb& from, const Aabb& to, std::size_t axis) {
  return std::abs(to.min[axis] - from.min[axis]);
}

std::size_t moved_in_a_frame(const SceneSettings& settings) {
  const auto source = frames_of(settings);
  EXPECT_TRUE(source->advance());
  return source->moved().size();
}

TEST(Stacks, LieOnEachOtherAtFrameZero) {
  const auto source = frames_of({.scene = "stacks", .bodies = 1'000});
  EXPECT_EQ(test::count_pairs(source->boxes()), 900U);
  for (BodyId id = 0; id < 1'000; ++id) {
    if (id % 10 == 0) continue;
    EXPECT_EQ(source->boxes()[id].min[1], source->boxes()[id - 1].max[1]);
  }
}

TEST(Stacks, TrembleByAThousandthAtMostAndNeverWander) {
  const auto source = frames_of({.scene = "stacks", .bodies = 200});
  const std::vector<Aabb> rest = copy(source->boxes());
  float farthest = 0;
  for (int frame = 0; frame < 500; ++frame) {
    ASSERT_TRUE(source->advance());
    for (const BodyId id : source->moved()) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        farthest = std::max(farthest, way(rest[id], source->boxes()[id], axis));
      }
    }
  }
  EXPECT_LE(farthest, 1e-3F + 1e-6F) << "the tremble and the rounding of a corner";
  EXPECT_GT(farthest, 8e-4F);
}

TEST(Stacks, TrembleAsManyAsWereAskedFor) {
  EXPECT_GT(moved_in_a_frame({.scene = "stacks", .bodies = 100}), 95U);
  const std::size_t moved = moved_in_a_frame({.scene = "stacks", .bodies = 1'000, .moving = 0.25});
  EXPECT_LE(moved, 250U);
  EXPECT_GT(moved, 220U) << "a millionth may be less than a step of a float";
}

TEST(Pile, StandsOnAPlaneAThousandTimesAsWide) {
  const auto source = frames_of({.scene = "pile", .bodies = 1'000});
  const Aabb bounds = *scene_bounds({.scene = "pile", .bodies = 1'000});
  const Aabb plane = source->boxes()[0];
  EXPECT_EQ(plane.max[1], 0);
  EXPECT_NEAR(edge(plane) / edge(bounds), 1'000, 0.1);
  EXPECT_NEAR(edge(plane, 2) / edge(bounds, 2), 1'000, 0.1);
}

TEST(Pile, HasItsPlaneWhereItWasAskedFor) {
  EXPECT_EQ(frames_of({.scene = "pile", .bodies = 100, .giant = GiantSlot::middle})->boxes()[50].max[1], 0);
  EXPECT_EQ(frames_of({.scene = "pile", .bodies = 100, .giant = GiantSlot::last})->boxes()[99].max[1], 0);
}

TEST(Pile, FallsAndSettlesInAHeapThatTrembles) {
  const auto source = frames_of({.scene = "pile", .bodies = 1'000});
  const std::vector<Aabb> start = copy(source->boxes());
  for (int frame = 0; frame < 400; ++frame) ASSERT_TRUE(source->advance());
  const std::vector<Aabb> heap = copy(source->boxes());
  std::size_t on_the_plane = 0;
  for (int frame = 0; frame < 50; ++frame) {
    ASSERT_TRUE(source->advance());
    for (BodyId id = 1; id < 1'000; ++id) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_LE(way(heap[id], source->boxes()[id], axis), 2e-4F + 1e-5F);
      }
    }
  }
  float highest = 0;
  for (BodyId id = 1; id < 1'000; ++id) {
    EXPECT_GE(start[id].min[1], heap[id].min[1] - 2e-4F) << "nobody rises";
    highest = std::max(highest, start[id].min[1] - heap[id].min[1]);
    on_the_plane += heap[id].min[1] <= 2e-4F ? 1 : 0;
  }
  EXPECT_GT(highest, 18);
  EXPECT_GT(on_the_plane, 100U);
}

TEST(Level, HasExactlyFivePercentMoversAndTilesThatStay) {
  const auto source = frames_of({.scene = "level", .bodies = 2'000});
  const std::vector<Aabb> start = copy(source->boxes());
  std::set<BodyId> movers;
  for (int frame = 0; frame < 50; ++frame) {
    ASSERT_TRUE(source->advance());
    EXPECT_EQ(source->moved().size(), 100U);
    movers.insert(source->moved().begin(), source->moved().end());
  }
  EXPECT_EQ(movers.size(), 100U);
  for (const BodyId id : movers) EXPECT_EQ(source->boxes()[id].min[1], start[id].min[1]) << "they walk";
}

TEST(Level, IsMadeOfTilesThatTouch) {
  const auto source = frames_of({.scene = "level", .bodies = 400, .moving = 0});
  EXPECT_EQ(test::count_pairs(source->boxes()), 2U * 20 * 19 + 2U * 19 * 19) << "sides and corners";
}

TEST(Ragdolls, HaveTwelveBodiesThatHoldTogetherInEveryFrame) {
  constexpr std::array<std::pair<BodyId, BodyId>, 11> kLinks = {
      {{0, 1}, {1, 2}, {2, 3}, {2, 4}, {4, 5}, {2, 6}, {6, 7}, {0, 8}, {8, 9}, {0, 10}, {10, 11}}};
  const auto source = frames_of({.scene = "ragdolls", .bodies = 240, .moving = 1});
  for (int frame = 0; frame < 500; ++frame) {
    for (BodyId ragdoll = 0; ragdoll < 240; ragdoll += 12) {
      for (const auto& [a, b] : kLinks) {
        ASSERT_TRUE(overlap(source->boxes()[ragdoll + a], source->boxes()[ragdoll + b]))
            << "ragdoll " << ragdoll / 12 << ", frame " << frame;
      }
    }
    ASSERT_TRUE(source->advance());
  }
}

TEST(Ragdolls, AreAsleepButForOneInAHundred) {
  const auto source = frames_of({.scene = "ragdolls", .bodies = 12 * 700});
  std::set<BodyId> awake;
  for (int frame = 0; frame < 30; ++frame) {
    ASSERT_TRUE(source->advance());
    for (const BodyId id : source->moved()) awake.insert(id / 12);
  }
  EXPECT_EQ(awake.size(), 7U);
  EXPECT_EQ(source->moved().size(), 84U);
}

TEST(Ragdolls, TouchTheirNeighbours) {
  const auto source = frames_of({.scene = "ragdolls", .bodies = 1'200});
  std::size_t between = 0;
  for (BodyId a = 0; a < 1'200; ++a) {
    for (BodyId b = a + 1; b < 1'200; ++b) {
      between += a / 12 != b / 12 && overlap(source->boxes()[a], source->boxes()[b]) ? 1 : 0;
    }
  }
  EXPECT_GT(between, 20U);
}

TEST(OpenWorld, LosesABatchOrGetsOneInEachFrame) {
  const auto source = frames_of({.scene = "open-world", .bodies = 6'400});
  for (int frame = 1; frame <= 600; ++frame) {
    ASSERT_TRUE(source->advance());
    const bool goes = (frame - 1) % 16 < 8;
    ASSERT_EQ(source->removed().size(), goes ? 100U : 0U) << frame;
    ASSERT_EQ(source->inserted().size(), goes ? 0U : 100U) << frame;
    ASSERT_GE(source->bodies().size(), 5'600U);
  }
}

TEST(OpenWorld, GivesTheIdsOfBodiesThatWentToThoseThatCome) {
  const auto source = frames_of({.scene = "open-world", .bodies = 1'000});
  std::map<BodyId, Aabb> gone;
  std::size_t again = 0;
  for (int frame = 0; frame < 64; ++frame) {
    const std::vector<Aabb> before = copy(source->boxes());
    ASSERT_TRUE(source->advance());
    for (const BodyId id : source->removed()) gone[id] = before[id];
    for (const BodyId id : source->inserted()) {
      ASSERT_TRUE(gone.contains(id));
      again += gone[id] == source->boxes()[id] ? 0 : 1;
    }
  }
  EXPECT_EQ(again, 4U * 125) << "each is another body than the one that went";
}

TEST(OpenWorld, IsAroundACameraThatGoesAllAroundItsWorld) {
  const SceneSettings settings{.scene = "open-world", .bodies = 3'200};
  const Aabb bounds = *scene_bounds(settings);
  const auto source = frames_of(settings);
  std::set<std::pair<int, int>> corners;
  for (int frame = 0; frame < 16 * 32; ++frame) {
    ASSERT_TRUE(source->advance());
    std::array<double, 3> middle{};
    for (const BodyId id : source->bodies()) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        middle[axis] += static_cast<double>(source->boxes()[id].min[axis]);
      }
    }
    const auto third = [&](std::size_t axis) {
      const double place = middle[axis] / static_cast<double>(source->bodies().size());
      return static_cast<int>(std::floor(3 * place / static_cast<double>(bounds.max[axis])));
    };
    corners.insert({third(0), third(2)});
  }
  for (const auto& corner : {std::pair{0, 0}, std::pair{2, 0}, std::pair{2, 2}, std::pair{0, 2}}) {
    EXPECT_TRUE(corners.contains(corner)) << corner.first << ' ' << corner.second;
  }
}

TEST(Bullets, FlyFurtherThanTheirEdgeInEveryFrame) {
  const auto source = frames_of({.scene = "bullets", .bodies = 1'000});
  for (int frame = 0; frame < 100; ++frame) {
    const std::vector<Aabb> before = copy(source->boxes());
    ASSERT_TRUE(source->advance());
    ASSERT_EQ(source->moved().size(), 100U);
    for (const BodyId id : source->moved()) {
      double square = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double step = static_cast<double>(way(before[id], source->boxes()[id], axis));
        square += step * step;
      }
      EXPECT_NEAR(edge(source->boxes()[id]), 0.1F, 1e-5F);
      ASSERT_GT(std::sqrt(square), 0.199);
      ASSERT_LT(std::sqrt(square), 0.801);
    }
  }
}

TEST(Swarm, IsOfOneSizeThickestInTheMiddleAndAllMove) {
  const SceneSettings settings{.scene = "swarm", .bodies = 4'000};
  const auto source = frames_of(settings);
  const float width = edge(*scene_bounds(settings));
  std::size_t in_the_middle = 0;
  for (const Aabb& box : source->boxes()) {
    EXPECT_NEAR(edge(box), 0.1F, 1e-6F);
    in_the_middle += box.min[0] > 0.25F * width && box.max[0] < 0.75F * width ? 1 : 0;
  }
  EXPECT_GT(in_the_middle, 3'000U);
  EXPECT_EQ(moved_in_a_frame(settings), 4'000U);
}

TEST(Sleepers, AreAsleepButForTheSameOneInEveryFrame) {
  const auto source = frames_of({.scene = "sleepers", .bodies = 1'000});
  ASSERT_TRUE(source->advance());
  ASSERT_EQ(source->moved().size(), 1U);
  const BodyId mover = source->moved().front();
  for (int frame = 0; frame < 100; ++frame) {
    ASSERT_TRUE(source->advance());
    ASSERT_EQ(source->moved().size(), 1U);
    EXPECT_EQ(source->moved().front(), mover);
  }
  EXPECT_EQ(moved_in_a_frame({.scene = "sleepers", .bodies = 0}), 0U);
}

TEST(Dust, HasSizesOverSixDecadesAndGiantsFullOfDust) {
  const World world = *make_scene({.scene = "dust", .bodies = 20'000});
  std::array<std::size_t, 6> decades{};
  std::vector<Aabb> boxes = test::boxes_of(world);
  for (const RigidBody& body : world.bodies()) {
    const double size = 2 * static_cast<double>(body.half_extents[0]);
    ++decades.at(static_cast<std::size_t>(std::floor(std::log10(size)) + 3));
  }
  for (std::size_t decade = 0; decade < 3; ++decade)
    EXPECT_NEAR(static_cast<double>(decades[decade]), 6'600, 300) << decade;
  for (std::size_t decade = 3; decade < 6; ++decade)
    EXPECT_NEAR(static_cast<double>(decades[decade]), 67, 25) << decade;
  const auto pairs = static_cast<double>(test::count_pairs(boxes));
  EXPECT_GT(pairs, 10'000);
  EXPECT_LT(pairs, 40'000);
}

TEST(Axis, TellsNothingApartOnTheOtherTwoForGood) {
  const auto source = frames_of({.scene = "axis", .bodies = 500, .moving = 1});
  for (int frame = 0; frame < 200; ++frame) ASSERT_TRUE(source->advance());
  for (const Aabb& box : source->boxes()) {
    for (const std::size_t axis : {1U, 2U}) {
      EXPECT_EQ(box.min[axis], 0.5F);
      EXPECT_EQ(box.max[axis], 1.5F);
    }
  }
  EXPECT_NEAR(static_cast<double>(test::count_pairs(source->boxes())), 250, 60);
}

}  // namespace
}  // namespace cellsweep
