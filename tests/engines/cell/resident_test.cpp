/// @file
/// Residency: what cell-resident's SPUs hear of and what not, how long they live, and how much they hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <string_view>

#include "cellsweep/world/scene.h"
#include "engines/cell/cell_world.h"
#include "engines/cell/ppu/dma_memory.h"
#include "engines/oracle/brute_force.h"

namespace cellsweep::cell {
namespace {

using contract::Random;

/// Sanitizers make a program's data larger than it is.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t kSanitizerBytes = 64 << 10;
#elif defined(__has_feature)
constexpr std::uint64_t kSanitizerBytes =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ? 64 << 10 : 0;
#else
constexpr std::uint64_t kSanitizerBytes = 0;
#endif

Broadphase make(const CellResidentOptions& options = {}) {
  return cell::make<CellResidentOptions>(options);
}

TEST(Resident, ProgramsAreStartedOnceForAllUpdates) {
  Broadphase engine = make();
  auto frames = std::move(*make_scene_frames({.bodies = 64, .moving = 0.5}));
  ASSERT_TRUE(insert_all(engine, *frames).ok());
  for (int frame = 0; frame < 200; ++frame) {
    ASSERT_TRUE(engine.update().ok());
    ASSERT_TRUE(frames->advance());
    ASSERT_TRUE(move_changed(engine, *frames).ok());
  }
  EXPECT_EQ(counter(engine, "programs started"), 3U);
}

TEST(Resident, NoSpuHearsOfAFrameInWhichNothingMoved) {
  Broadphase engine = make();
  ASSERT_TRUE(engine.insert(ids_up_to(2), std::vector<Aabb>{cube(0), cube(0.5F)}).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "mailbox words"), 3U);
  for (int frame = 0; frame < 10; ++frame) {
    ASSERT_TRUE(engine.move(1, cube(0.5F)).ok()) << "to where it is";
    const auto changes = engine.update();
    ASSERT_TRUE(changes.ok());
    EXPECT_TRUE(changes->began.empty() && changes->ended.empty());
  }
  EXPECT_EQ(counter(engine, "mailbox words"), 3U);
  EXPECT_EQ(counter(engine, "bodies sent"), 2U);
  EXPECT_EQ(engine.pairs().size(), 1U);
}

TEST(Resident, OnlyChangedBodiesAreSentAndOnlyChangedPairsComeBack) {
  Broadphase engine = make();
  const std::size_t count = 100;
  ASSERT_TRUE(engine.insert(ids_up_to(count), std::vector<Aabb>(count, cube(0))).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "events"), count * (count - 1) / 2);
  ASSERT_TRUE(engine.move(7, cube(0.5F)).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "bodies sent"), count + 1);
  EXPECT_EQ(counter(engine, "events"), count * (count - 1) / 2) << "all pairs of body 7 still overlap";
  ASSERT_TRUE(engine.move(7, cube(5)).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "events"), count * (count - 1) / 2 + count - 1);
}

TEST(Resident, ABodyThatComesAndGoesBetweenUpdatesIsNotSent) {
  Broadphase engine = make();
  ASSERT_TRUE(engine.insert(1, cube(0)).ok());
  ASSERT_TRUE(engine.move(1, cube(1)).ok());
  ASSERT_TRUE(engine.remove(1).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "bodies sent"), 0U);
}

TEST(Resident, ABodyMovedOftenBetweenUpdatesCountsAsItIsLast) {
  Broadphase engine = make();
  ASSERT_TRUE(engine.insert(ids_up_to(3), std::vector<Aabb>{cube(0), cube(10), cube(20)}).ok());
  ASSERT_TRUE(engine.update().ok());
  for (int i = 0; i < 5000; ++i) {
    ASSERT_TRUE(engine.move(1, cube(static_cast<float>(i % 30))).ok());
    ASSERT_TRUE(engine.move(2, cube(static_cast<float>(i % 7))).ok());
  }
  ASSERT_TRUE(engine.move(2, cube(0.5F)).ok());
  const auto changes = engine.update();
  ASSERT_TRUE(changes.ok());
  EXPECT_THAT(changes->began, testing::ElementsAre(Pair{0, 2}));
  EXPECT_THAT(engine.pairs(), testing::ElementsAre(Pair{0, 2}));
  EXPECT_LT(counter(engine, "bodies sent"), 50U);
}

TEST(Resident, EndsCleanlyAtAnyTime) {
  for (int round = 0; round < 20; ++round) {
    make();
    Broadphase engine = make();
    ASSERT_TRUE(engine.insert(1, cube(0)).ok());
    if (round % 2 == 0) continue;
    ASSERT_TRUE(engine.update().ok());
    ASSERT_TRUE(engine.move(1, cube(1)).ok());
  }
}

/// Random inserts, moves and removes against the oracle.
void live(const CellResidentOptions& options, std::size_t most, std::uint64_t seed, int updates) {
  Random random(seed);
  Broadphase engine = make(options);
  std::map<BodyId, Aabb> model;
  for (int step = 0; step < updates; ++step) {
    const std::vector<Aabb> boxes = random_boxes(random, most);
    std::vector<BodyId> gone;
    std::vector<BodyId> moved;
    std::vector<Aabb> moved_boxes;
    for (BodyId id = 0; id < most; ++id) {
      const bool is_there = model.count(id) != 0;
      if (!is_there && random.one_in(3)) {
        ASSERT_TRUE(engine.insert(id, boxes[id]).ok());
        model[id] = boxes[id];
      } else if (is_there && random.one_in(8)) {
        gone.push_back(id);
        model.erase(id);
      } else if (is_there && random.one_in(2)) {
        moved.push_back(id);
        moved_boxes.push_back(boxes[id]);
        model[id] = boxes[id];
      }
    }
    ASSERT_TRUE(engine.move(moved, moved_boxes).ok());
    ASSERT_TRUE(engine.remove(gone).ok());
    ASSERT_TRUE(engine.update().ok());
    std::vector<BodyId> ids;
    std::vector<Aabb> now;
    for (const auto& [id, box] : model) {
      ids.push_back(id);
      now.push_back(box);
    }
    ASSERT_EQ(pairs_of(engine), brute_force_pairs(ids, now)) << "seed " << seed << ", update " << step;
  }
}

TEST(Resident, LateDmaWithManySeedsChangesNothing) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    ASSERT_NO_FATAL_FAILURE(live({.spes = {.dma = DmaMode::late, .dma_seed = seed}}, 90, seed, 12));
  }
}

TEST(Resident, AnyNumberOfSpusFindsTheSamePairs) {
  for (const unsigned spus : {3U, 4U, 5U, 6U, 7U, 16U}) {
    ASSERT_NO_FATAL_FAILURE(live({.spus = spus}, 120, spus, 12)) << spus << " SPUs";
  }
}

TEST(Resident, UncheckedDmaAndNoLimitFindTheSamePairs) {
  ASSERT_NO_FATAL_FAILURE(live({.spes = {.local_store = 0, .dma = DmaMode::unchecked}}, 120, 3, 12));
}

TEST(Resident, WhatDoesNotFitIntoOneOrderBecomesSeveral) {
  Random random(9);
  Broadphase engine = make({.spes = {.local_store = 88 << 10}});
  const auto count = static_cast<std::size_t>(engine.capacity().bodies);
  const std::vector<BodyId> ids = ids_up_to(count);
  ASSERT_TRUE(engine.insert(ids, random_boxes(random, count)).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_GE(counter(engine, "mailbox words"), 6U) << "one order took all";
  for (int round = 0; round < 20; ++round) {
    const std::vector<Aabb> boxes = random_boxes(random, count);
    ASSERT_TRUE(engine.move(ids, boxes).ok());
    ASSERT_TRUE(engine.update().ok());
    ASSERT_EQ(pairs_of(engine), brute_force_pairs(boxes)) << "round " << round;
  }
  ASSERT_TRUE(engine.remove(ids).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_TRUE(engine.pairs().empty());
}

TEST(Resident, FewerSpusThanAxesAndTooManyAreRefused) {
  for (const unsigned spus : {1U, 2U, 17U}) {
    const Status status = make_broadphase(CellResidentOptions{.spus = spus}).status();
    EXPECT_EQ(status.code, StatusCode::bad_option);
    EXPECT_EQ(status.setting, "spus");
  }
}

TEST(Resident, ALocalStoreWithoutRoomForOneBodyIsRefusedWithItsMap) {
  const Status status = make_broadphase(CellResidentOptions{.spes = {.local_store = 72 << 10}}).status();
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.setting, "local_store");
  EXPECT_THAT(status.message, testing::HasSubstr("changed boxes"));
}

TEST(Resident, TwoThousandBodiesFit) {
  EXPECT_GE(make().capacity().bodies, 2000U);
}

TEST(Resident, TooManyBodiesAreRefusedWithTheMapOfTheLocalStore) {
  Broadphase engine = make();
  const auto too_many = static_cast<std::size_t>(engine.capacity().bodies) + 1;
  const Status status = engine.insert(ids_up_to(too_many), std::vector<Aabb>(too_many, cube(0)));
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.setting, "local_store");
  for (const char* part :
       {"code", "stack", "sorted boxes", "reach of boxes", "places of bodies", "changed boxes",
        "changed boxes before", "order of changed boxes", "events", "262144"}) {
    EXPECT_THAT(status.message, testing::HasSubstr(part));
  }
}

class ResidentLocalStore : public testing::TestWithParam<bool> {};

TEST_P(ResidentLocalStore, IsFilledNoFurtherThanTheMapSays) {
  for (const std::uint64_t kilobytes : {96U, 100U, 128U, 192U, 256U}) {
    const CellResidentOptions options{.spes = {.local_store = kilobytes << 10}, .spu_boxes = GetParam()};
    Broadphase engine = make(options);
    const auto bodies = static_cast<std::size_t>(engine.capacity().bodies);
    ASSERT_GT(bodies, 16U) << kilobytes << " KB";
    ASSERT_TRUE(engine.insert(ids_up_to(bodies), std::vector<Aabb>(bodies, cube(0))).ok());
    ASSERT_TRUE(engine.remove(ids_up_to(bodies)).ok());
    ASSERT_TRUE(engine.insert(1, cube(1)).ok());
    ASSERT_TRUE(engine.update().ok());
    const auto map = local_store_map(options, bodies);
    ASSERT_TRUE(map.ok());
    EXPECT_TRUE(map->fits());
    EXPECT_FALSE(local_store_map(options, bodies + 1)->fits());
    EXPECT_LE(cell_statistics(engine)->local_store_high_water, map->used() + kSanitizerBytes);
  }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutPoses, ResidentLocalStore, testing::Bool());

TEST(Resident, PosesCostLocalStoreOnlyWhenTheyAreTaken) {
  const Broadphase with_boxes = make({.spu_boxes = true});
  EXPECT_LT(with_boxes.capacity().bodies, make().capacity().bodies);
  EXPECT_THAT(with_boxes.capacity().reason, testing::HasSubstr("intervals of poses"));
  EXPECT_THAT(make().capacity().reason, testing::Not(testing::HasSubstr("poses")));
}

TEST(Resident, AThousandIdenticalBodiesSendHalfAMillionPairs) {
  Broadphase engine = make();
  const std::size_t count = 1000;
  const std::vector<BodyId> ids = ids_up_to(count);
  ASSERT_TRUE(engine.insert(ids, std::vector<Aabb>(count, cube(0))).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(engine.pairs().size(), count * (count - 1) / 2);
  ASSERT_TRUE(engine.move(ids, std::vector<Aabb>(count, cube(0.25F))).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "events"), count * (count - 1) / 2) << "no pair began or ended";
  ASSERT_TRUE(engine.remove(ids).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_TRUE(engine.pairs().empty());
}

/// The system reads what it writes into a pipe, or says that nobody may.
TEST(DmaPages, EndWhereNothingMayBeTouched) {
  std::array<int, 2> pipe_ends{};
  ASSERT_EQ(pipe(pipe_ends.data()), 0);
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{128}, std::size_t{1000}, std::size_t{300000}}) {
    const DmaPages pages(bytes);
    const std::size_t lines = (bytes + kDmaAlign - 1) / kDmaAlign * kDmaAlign;
    const std::byte* end = static_cast<const std::byte*>(pages.get()) + lines;
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(pages.get()) % kDmaAlign, 0U);
    EXPECT_EQ(write(pipe_ends[1], end - 1, 1), 1) << bytes;
    EXPECT_EQ(write(pipe_ends[1], end, 1), -1) << bytes;
  }
  close(pipe_ends[0]);
  close(pipe_ends[1]);
}

}  // namespace
}  // namespace cellsweep::cell
