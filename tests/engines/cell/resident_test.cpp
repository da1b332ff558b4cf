/// @file
/// Residency: what cell-resident's SPUs hear of and what not, how long they live, and how much they hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string_view>

#include "cellsweep/engines.h"
#include "cellsweep/local_store.h"
#include "cellsweep/world/scene.h"
#include "contract/random.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/resident.h"
#include "engines/oracle/brute_force.h"
#include "report/run_engine.h"

namespace cellsweep {
namespace {

using contract::Random;

constexpr std::string_view kName = "cell-resident";

/// Sanitizers make a program's data larger than it is.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t kSanitizerBytes = 64 << 10;
#elif defined(__has_feature)
constexpr std::uint64_t kSanitizerBytes =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ? 64 << 10 : 0;
#else
constexpr std::uint64_t kSanitizerBytes = 0;
#endif

std::unique_ptr<Broadphase> make(const EngineOptions& options = {}) {
  auto engine = make_engine(kName, options);
  EXPECT_TRUE(engine.ok()) << engine.status().message;
  return std::move(*engine);
}

std::uint64_t counter(const Broadphase& engine, std::string_view name) {
  for (const Counter& one : engine.statistics().counters) {
    if (one.name == name) return one.value;
  }
  ADD_FAILURE() << "no counter is called " << name;
  return 0;
}

std::vector<Pair> sorted_pairs(const Broadphase& engine) {
  std::vector<Pair> pairs(engine.pairs().begin(), engine.pairs().end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<BodyId> ids_up_to(std::size_t count) {
  std::vector<BodyId> ids(count);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  return ids;
}

Aabb cube(float at) {
  return {{at, at, at}, {at + 1, at + 1, at + 1}};
}

/// Boxes of a hundred bodies in a small world; each overlaps a few others.
std::vector<Aabb> random_boxes(Random& random, std::size_t count) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      box.min[axis] = random.between(-5, 5);
      box.max[axis] = box.min[axis] + random.between(0, random.one_in(20) ? 8.0F : 1.5F);
    }
    boxes.push_back(box);
  }
  return boxes;
}

TEST(Resident, ProgramsAreStartedOnceForAllUpdates) {
  const auto engine = make();
  auto frames = std::move(*make_scene_frames({.bodies = 64, .moving = 0.5}));
  ASSERT_TRUE(report::insert_all(*engine, *frames).ok());
  for (int frame = 0; frame < 200; ++frame) {
    ASSERT_TRUE(engine->update().ok());
    ASSERT_TRUE(frames->advance());
    ASSERT_TRUE(report::move_changed(*engine, *frames).ok());
  }
  EXPECT_EQ(counter(*engine, "programs started"), 3U);
}

TEST(Resident, NoSpuHearsOfAFrameInWhichNothingMoved) {
  const auto engine = make();
  ASSERT_TRUE(engine->insert(ids_up_to(2), std::vector<Aabb>{cube(0), cube(0.5F)}).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_EQ(counter(*engine, "mailbox words"), 3U);
  for (int frame = 0; frame < 10; ++frame) {
    ASSERT_TRUE(engine->move(1, cube(0.5F)).ok()) << "to where it is";
    const auto changes = engine->update();
    ASSERT_TRUE(changes.ok());
    EXPECT_TRUE(changes->began.empty() && changes->ended.empty());
  }
  EXPECT_EQ(counter(*engine, "mailbox words"), 3U);
  EXPECT_EQ(counter(*engine, "bodies sent"), 2U);
  EXPECT_EQ(engine->pairs().size(), 1U);
}

TEST(Resident, OnlyChangedBodiesAreSentAndOnlyChangedPairsComeBack) {
  const auto engine = make();
  const std::size_t count = 100;
  ASSERT_TRUE(engine->insert(ids_up_to(count), std::vector<Aabb>(count, cube(0))).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_EQ(counter(*engine, "events"), count * (count - 1) / 2);
  ASSERT_TRUE(engine->move(7, cube(0.5F)).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_EQ(counter(*engine, "bodies sent"), count + 1);
  EXPECT_EQ(counter(*engine, "events"), count * (count - 1) / 2) << "all pairs of body 7 still overlap";
  ASSERT_TRUE(engine->move(7, cube(5)).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_EQ(counter(*engine, "events"), count * (count - 1) / 2 + count - 1);
}

TEST(Resident, ABodyThatComesAndGoesBetweenUpdatesIsNotSent) {
  const auto engine = make();
  ASSERT_TRUE(engine->insert(1, cube(0)).ok());
  ASSERT_TRUE(engine->move(1, cube(1)).ok());
  ASSERT_TRUE(engine->remove(1).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_EQ(counter(*engine, "bodies sent"), 0U);
}

TEST(Resident, ABodyMovedOftenBetweenUpdatesCountsAsItIsLast) {
  const auto engine = make();
  ASSERT_TRUE(engine->insert(ids_up_to(3), std::vector<Aabb>{cube(0), cube(10), cube(20)}).ok());
  ASSERT_TRUE(engine->update().ok());
  for (int i = 0; i < 5000; ++i) {
    ASSERT_TRUE(engine->move(1, cube(static_cast<float>(i % 30))).ok());
    ASSERT_TRUE(engine->move(2, cube(static_cast<float>(i % 7))).ok());
  }
  ASSERT_TRUE(engine->move(2, cube(0.5F)).ok());
  const auto changes = engine->update();
  ASSERT_TRUE(changes.ok());
  EXPECT_THAT(changes->began, testing::ElementsAre(Pair{0, 2}));
  EXPECT_THAT(engine->pairs(), testing::ElementsAre(Pair{0, 2}));
  EXPECT_LT(counter(*engine, "bodies sent"), 50U);
}

TEST(Resident, EndsCleanlyAtAnyTime) {
  for (int round = 0; round < 20; ++round) {
    make();
    const auto engine = make();
    ASSERT_TRUE(engine->insert(1, cube(0)).ok());
    if (round % 2 == 0) continue;
    ASSERT_TRUE(engine->update().ok());
    ASSERT_TRUE(engine->move(1, cube(1)).ok());
  }
}

/// Random inserts, moves and removes against the oracle.
void live(const EngineOptions& options, std::size_t most, std::uint64_t seed, int updates) {
  Random random(seed);
  const auto engine = make(options);
  std::map<BodyId, Aabb> model;
  for (int step = 0; step < updates; ++step) {
    const std::vector<Aabb> boxes = random_boxes(random, most);
    std::vector<BodyId> gone;
    std::vector<BodyId> moved;
    std::vector<Aabb> moved_boxes;
    for (BodyId id = 0; id < most; ++id) {
      const bool is_there = model.count(id) != 0;
      if (!is_there && random.one_in(3)) {
        ASSERT_TRUE(engine->insert(id, boxes[id]).ok());
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
    ASSERT_TRUE(engine->move(moved, moved_boxes).ok());
    ASSERT_TRUE(engine->remove(gone).ok());
    ASSERT_TRUE(engine->update().ok());
    std::vector<BodyId> ids;
    std::vector<Aabb> now;
    for (const auto& [id, box] : model) {
      ids.push_back(id);
      now.push_back(box);
    }
    ASSERT_EQ(sorted_pairs(*engine), brute_force_pairs(ids, now)) << "seed " << seed << ", update " << step;
  }
}

TEST(Resident, LateDmaWithManySeedsChangesNothing) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    ASSERT_NO_FATAL_FAILURE(live({.dma = DmaMode::late, .dma_seed = seed}, 90, seed, 12));
  }
}

TEST(Resident, AnyNumberOfSpusFindsTheSamePairs) {
  for (const unsigned spus : {3U, 4U, 5U, 6U, 7U, 16U}) {
    ASSERT_NO_FATAL_FAILURE(live({.spus = spus}, 120, spus, 12)) << spus << " SPUs";
  }
}

TEST(Resident, UncheckedDmaAndNoLimitFindTheSamePairs) {
  ASSERT_NO_FATAL_FAILURE(live({.local_store_bytes = 0, .dma = DmaMode::unchecked}, 120, 3, 12));
}

TEST(Resident, WhatDoesNotFitIntoOneOrderBecomesSeveral) {
  Random random(9);
  const auto engine = make({.local_store_bytes = 88 << 10});
  const auto count = static_cast<std::size_t>(engine->capacity().bodies);
  const std::vector<BodyId> ids = ids_up_to(count);
  ASSERT_TRUE(engine->insert(ids, random_boxes(random, count)).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_GE(counter(*engine, "mailbox words"), 6U) << "one order took all";
  for (int round = 0; round < 20; ++round) {
    const std::vector<Aabb> boxes = random_boxes(random, count);
    ASSERT_TRUE(engine->move(ids, boxes).ok());
    ASSERT_TRUE(engine->update().ok());
    ASSERT_EQ(sorted_pairs(*engine), brute_force_pairs(boxes)) << "round " << round;
  }
  ASSERT_TRUE(engine->remove(ids).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_TRUE(engine->pairs().empty());
}

TEST(Resident, FewerSpusThanAxesAndTooManyAreRefused) {
  for (const unsigned spus : {1U, 2U, 17U}) {
    const auto engine = make_engine(kName, {.spus = spus});
    ASSERT_FALSE(engine.ok());
    EXPECT_EQ(engine.status().code, StatusCode::bad_option);
    EXPECT_EQ(engine.status().setting, "spus");
  }
}

TEST(Resident, ALocalStoreWithoutRoomForOneBodyIsRefusedWithItsMap) {
  const auto engine = make_engine(kName, {.local_store_bytes = 72 << 10});
  ASSERT_FALSE(engine.ok());
  EXPECT_EQ(engine.status().code, StatusCode::bad_option);
  EXPECT_EQ(engine.status().setting, "local_store_bytes");
  EXPECT_THAT(engine.status().message, testing::HasSubstr("changed boxes"));
}

TEST(Resident, TwoThousandBodiesFit) {
  EXPECT_GE(make()->capacity().bodies, 2000U);
}

TEST(Resident, TooManyBodiesAreRefusedWithTheMapOfTheLocalStore) {
  const auto engine = make();
  const auto too_many = static_cast<std::size_t>(engine->capacity().bodies) + 1;
  const Status status = engine->insert(ids_up_to(too_many), std::vector<Aabb>(too_many, cube(0)));
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.setting, "local_store_bytes");
  for (const char* part :
       {"code", "stack", "sorted boxes", "reach of boxes", "places of bodies", "changed boxes",
        "changed boxes before", "order of changed boxes", "events", "262144"}) {
    EXPECT_THAT(status.message, testing::HasSubstr(part));
  }
}

class ResidentLocalStore : public testing::TestWithParam<bool> {};

TEST_P(ResidentLocalStore, IsFilledNoFurtherThanTheMapSays) {
  for (const std::uint64_t kilobytes : {96U, 100U, 128U, 192U, 256U}) {
    const EngineOptions options{.local_store_bytes = kilobytes << 10, .spu_boxes = GetParam()};
    const auto engine = make(options);
    const auto bodies = static_cast<std::size_t>(engine->capacity().bodies);
    ASSERT_GT(bodies, 16U) << kilobytes << " KB";
    ASSERT_TRUE(engine->insert(ids_up_to(bodies), std::vector<Aabb>(bodies, cube(0))).ok());
    ASSERT_TRUE(engine->remove(ids_up_to(bodies)).ok());
    ASSERT_TRUE(engine->insert(1, cube(1)).ok());
    ASSERT_TRUE(engine->update().ok());
    const auto map = local_store_map(kName, options, bodies);
    ASSERT_TRUE(map.ok());
    EXPECT_TRUE(map->fits());
    EXPECT_FALSE(local_store_map(kName, options, bodies + 1)->fits());
    EXPECT_LE(counter(*engine, "local store high water"), map->used() + kSanitizerBytes);
  }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutPoses, ResidentLocalStore, testing::Bool());

TEST(Resident, PosesCostLocalStoreOnlyWhenTheyAreTaken) {
  const auto with_boxes = make({.spu_boxes = true});
  EXPECT_LT(with_boxes->capacity().bodies, make()->capacity().bodies);
  EXPECT_THAT(with_boxes->capacity().reason, testing::HasSubstr("intervals of poses"));
  EXPECT_THAT(make()->capacity().reason, testing::Not(testing::HasSubstr("poses")));
}

TEST(Resident, AThousandIdenticalBodiesSendHalfAMillionPairs) {
  const auto engine = make();
  const std::size_t count = 1000;
  const std::vector<BodyId> ids = ids_up_to(count);
  ASSERT_TRUE(engine->insert(ids, std::vector<Aabb>(count, cube(0))).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_EQ(engine->pairs().size(), count * (count - 1) / 2);
  ASSERT_TRUE(engine->move(ids, std::vector<Aabb>(count, cube(0.25F))).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_EQ(counter(*engine, "events"), count * (count - 1) / 2) << "no pair began or ended";
  ASSERT_TRUE(engine->remove(ids).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_TRUE(engine->pairs().empty());
}

/// Gives out the first few contexts and then no more.
class FewSpes final : public cell::Emulation {
 public:
  FewSpes(std::shared_ptr<cell::Emulation> all, int few) : all_(std::move(all)), left_(few) {}

  cell::LocalStoreBudget local_store() const override { return all_->local_store(); }
  spe_program_handle_t& image(spe_program_handle_t& program) const override { return all_->image(program); }
  spe_context_ptr_t create_context(unsigned flags, unsigned spes) override {
    return left_-- > 0 ? all_->create_context(flags, spes) : nullptr;
  }
  cell::SpeCounts counts(spe_context_ptr_t spe) const override { return all_->counts(spe); }
  cell::SpeCycles cycles(spe_context_ptr_t spe) const override { return all_->cycles(spe); }
  std::string fault(spe_context_ptr_t spe) const override { return all_->fault(spe); }

 private:
  std::shared_ptr<cell::Emulation> all_;
  int left_;
};

TEST(Resident, TooFewSpesAreAStatusAndNoHang) {
  for (int few = 0; few < 3; ++few) {
    auto emulation = std::make_shared<FewSpes>(*cell::make_emulation({}), few);
    EXPECT_EQ(cell::Resident::make({}, emulation).status().code, StatusCode::spe_failed);
  }
}

/// Promises twice the local store that there is.
class Boaster final : public cell::Emulation {
 public:
  explicit Boaster(std::shared_ptr<cell::Emulation> all) : all_(std::move(all)) {}

  cell::LocalStoreBudget local_store() const override {
    cell::LocalStoreBudget budget = all_->local_store();
    budget.limit *= 2;
    return budget;
  }
  spe_program_handle_t& image(spe_program_handle_t& program) const override { return all_->image(program); }
  spe_context_ptr_t create_context(unsigned flags, unsigned spes) override {
    return all_->create_context(flags, spes);
  }
  cell::SpeCounts counts(spe_context_ptr_t spe) const override { return all_->counts(spe); }
  cell::SpeCycles cycles(spe_context_ptr_t spe) const override { return all_->cycles(spe); }
  std::string fault(spe_context_ptr_t spe) const override { return all_->fault(spe); }

 private:
  std::shared_ptr<cell::Emulation> all_;
};

TEST(Resident, AProgramThatFailsIsAStatusWithTheRuleItBroke) {
  const auto engine = cell::Resident::make({}, std::make_shared<Boaster>(*cell::make_emulation({})));
  ASSERT_FALSE(engine.ok());
  EXPECT_EQ(engine.status().code, StatusCode::spe_failed);
  EXPECT_THAT(engine.status().message, testing::HasSubstr("local store"));
}

}  // namespace
}  // namespace cellsweep
