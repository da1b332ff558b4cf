/// @file
/// What users of other broadphases complain of, each as a test that it is not so here.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engines/oracle/brute_force.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

TEST(Complaint, InsertingOneByOneDegradesNothing) {
  const std::vector<Aabb> boxes = uniform_boxes(2000 / kScale, 1);
  Broadphase one_by_one;
  for (BodyId id = 0; id < boxes.size(); ++id) {
    ASSERT_TRUE(one_by_one.insert(id, boxes[id]).ok());
    ASSERT_TRUE(one_by_one.update().ok());
  }
  EXPECT_TRUE(is_exact(one_by_one, boxes));
  EXPECT_LE(counter(one_by_one, "boxes in cells"), 5 * boxes.size());
}

TEST(Complaint, BodiesGivenAgainWhereTheyAreCostNoUpdate) {
  const std::vector<Aabb> boxes = uniform_boxes(5000 / kScale, 2);
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  const std::uint64_t changed = counter(engine, "fat boxes put into cells");
  for (int frame = 0; frame < 3; ++frame) {
    move_every(engine, boxes, 1);
    const auto changes = engine.update();
    EXPECT_TRUE(changes->began.empty() && changes->ended.empty());
  }
  EXPECT_EQ(counter(engine, "fat boxes put into cells"), changed);
  EXPECT_EQ(counter(engine, "idle updates"), 3U);
}

TEST(Complaint, ThereAreNoHandlesToRunOutOf) {
  // More than sixteen bits number, and ids from everywhere in the 32 that there are.
  const std::size_t count = 70'000 / kScale;
  std::vector<BodyId> ids;
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    ids.push_back(static_cast<BodyId>(i * (0xffffffffULL / count)));
    boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
  }
  Broadphase engine;
  ASSERT_TRUE(engine.insert(ids, boxes).ok());
  ASSERT_TRUE(engine.update().ok());
  ASSERT_EQ(engine.pairs().size(), count - 1);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    ASSERT_EQ(engine.pairs()[i], (Pair{ids[i], ids[i + 1]}));
  }
}

TEST(Complaint, ThereAreNoWorldBoundsToTune) {
  contract::Random random(3);
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < 600; ++i) {
    const float scale = std::ldexp(1.0F, random.whole(-120, 120));
    Aabb box = cube_in(random, 1, 4);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float sign = random.one_in(2) ? -1.0F : 1.0F;
      const float one = box.min[axis] * scale * sign;
      const float other = box.max[axis] * scale * sign;
      box.min[axis] = std::min(one, other);
      box.max[axis] = std::max(one, other);
    }
    boxes.push_back(box);
  }
  boxes.push_back({{-3e38F, -3e38F, -3e38F}, {3e38F, 3e38F, 3e38F}});
  boxes.push_back({{3e38F, 3e38F, 3e38F}, {3e38F, 3e38F, 3e38F}});
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_TRUE(is_exact(engine, boxes));
}

TEST(Complaint, AFewHugeBodiesDoNotMakeTheOthersPay) {
  std::vector<Aabb> boxes = uniform_boxes(8000 / kScale, 4);
  Broadphase without = engine_with(boxes);
  ASSERT_TRUE(without.update().ok());
  const float world = 2 * std::cbrt(static_cast<float>(boxes.size()));
  for (std::size_t i = 0; i < 4; ++i) boxes[100 * i] = {{0, 0, 0}, {world, world, world}};
  Broadphase with = engine_with(boxes);
  ASSERT_TRUE(with.update().ok());
  EXPECT_TRUE(is_exact(with, boxes));
  EXPECT_LE(counter(with, "boxes in cells"), 2 * counter(without, "boxes in cells"));
}

TEST(Complaint, AllBodiesOnOnePlaneAreNoSpecialCase) {
  // More than are swept, in sanitized tests, too.
  std::vector<Aabb> boxes = uniform_boxes(kScale == 1 ? 6000 : 2500, 5);
  contract::Random random(6);
  const float world = 2 * std::sqrt(static_cast<float>(boxes.size()));
  for (Aabb& box : boxes) {
    box = cube_in(random, 1, world);
    box.min[1] = 0;
    box.max[1] = 1;
  }
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_TRUE(is_exact(engine, boxes));
  EXPECT_GT(counter(engine, "pieces"), boxes.size() / 200);
  EXPECT_LE(counter(engine, "boxes in cells"), 3 * boxes.size());
  shake(boxes, 0.1F, 7);
  move_every(engine, boxes, 10);
}

TEST(Complaint, AThousandOnOneSpotDoNotSpoilTheRest) {
  std::vector<Aabb> boxes = uniform_boxes(8000 / kScale, 8);
  for (std::size_t i = 0; i < 1000 / kScale; ++i) boxes[i] = {{1, 1, 1}, {2, 2, 2}};
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_TRUE(is_exact(engine, boxes));
  EXPECT_LE(counter(engine, "boxes in cells"), 4 * boxes.size());
}

TEST(Complaint, NoPairIsLostAtScaleAndTouchingCounts) {
  // A lattice of touching cubes: each meets the 26 around it.
  const std::size_t side = kScale == 1 ? 60 : 20;
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < side * side * side; ++i) {
    const auto x = static_cast<float>(i % side);
    const auto y = static_cast<float>(i / side % side);
    const auto z = static_cast<float>(i / side / side);
    boxes.push_back({{x, y, z}, {x + 1, y + 1, z + 1}});
  }
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  const std::size_t along = 3 * side - 2;  // pairs of places on a line that touch, in order
  EXPECT_EQ(engine.pairs().size(), (along * along * along - boxes.size()) / 2);
}

TEST(Complaint, TheOrderOfPairsIsTheSameForAnyNumberOfThreadsAndEveryTime) {
  std::vector<Aabb> boxes = uniform_boxes(20'000 / kScale, 9);
  std::vector<Broadphase> engines;
  for (const unsigned threads : {1U, 2U, 3U, 16U, 16U, 0U}) {
    engines.push_back(engine_with(boxes, {.threads = threads}));
  }
  for (std::uint64_t frame = 0; frame < 6; ++frame) {
    std::vector<PairChanges> changes;
    for (Broadphase& engine : engines) changes.push_back(*engine.update());
    for (std::size_t i = 1; i < engines.size(); ++i) {
      EXPECT_TRUE(std::ranges::equal(engines[i].pairs(), engines[0].pairs()));
      EXPECT_TRUE(std::ranges::equal(changes[i].began, changes[0].began));
      EXPECT_TRUE(std::ranges::equal(changes[i].ended, changes[0].ended));
    }
    shake(boxes, 0.2F, frame);
    for (Broadphase& engine : engines) move_every(engine, boxes, frame % 2 == 0 ? 10 : 1);
  }
}

TEST(Complaint, ACapOfPairsStopsAnUpdateWhichSaysSo) {
  std::vector<Aabb> boxes = uniform_boxes(3000 / kScale, 11);
  const std::vector<Pair> truth = brute_force_pairs(boxes);
  for (const unsigned threads : {1U, 3U}) {
    Broadphase engine = engine_with(boxes, {.threads = threads, .max_pairs = truth.size()});
    ASSERT_TRUE(engine.update().ok());
    EXPECT_TRUE(is_exact(engine, boxes));
    std::vector<Aabb> crowd(boxes.size(), Aabb{{0, 0, 0}, {1, 1, 1}});
    for (const std::size_t every : {1, 2, 20}) {
      move_every(engine, crowd, every);
      const Status status = engine.update().status();
      EXPECT_EQ(status.code, StatusCode::capacity);
      EXPECT_EQ(status.limit, truth.size());
      EXPECT_EQ(status.setting, "max_pairs");
      EXPECT_THAT(status.message, testing::HasSubstr(std::to_string(truth.size())));
      EXPECT_TRUE(std::ranges::equal(engine.pairs(), truth));
      move_every(engine, boxes, every);
      const auto changes = engine.update();
      ASSERT_TRUE(changes.ok());
      EXPECT_TRUE(changes->began.empty() && changes->ended.empty());
    }
    EXPECT_TRUE(is_exact(engine, boxes));
  }
}

TEST(Complaint, ACapOfPairsIsReachedWithoutFindingAllPairs) {
  // Together 200 million pairs, which would be gigabytes.
  const std::vector<Aabb> boxes(20'000, Aabb{{0, 0, 0}, {1, 1, 1}});
  Broadphase engine = engine_with(boxes, {.max_pairs = 1000});
  EXPECT_EQ(engine.update().status().code, StatusCode::capacity);
  EXPECT_TRUE(engine.pairs().empty());
}

TEST(Complaint, ACapOfPairsCountsPairsAndNothingElse) {
  // Slow bodies in dense rows: very many fat boxes overlap where boxes do not.
  const auto row_at = [](float shift) {
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < 3000 / kScale; ++i) {
      const float x = 1.2F * static_cast<float>(i % 1000) + (i % 2 == 0 ? shift : -shift);
      const float y = 1.2F * static_cast<float>(i / 1000);
      boxes.push_back({{x, y, 0}, {x + 1, y + 1, 1}});
    }
    return boxes;
  };
  Broadphase engine = engine_with(row_at(0), {.max_pairs = 1});
  for (const float shift : {0.0F, 0.03F, 0.06F, 0.0F, -0.05F}) {
    move_every(engine, row_at(shift), 1);
    ASSERT_TRUE(engine.update().ok());
    EXPECT_TRUE(engine.pairs().empty());
  }
}

TEST(Complaint, MemoryIsGivenBack) {
  const std::vector<Aabb> boxes = uniform_boxes(50'000 / kScale, 10);
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  const std::uint64_t full = engine.statistics().bytes;
  EXPECT_LE(full, 400 * boxes.size() + 1'000'000);
  std::vector<BodyId> most = ids_below(boxes.size());
  most.erase(most.begin(), most.begin() + 100);
  ASSERT_TRUE(engine.remove(most).ok());
  ASSERT_TRUE(engine.update().ok());
  ASSERT_TRUE(engine.move(0, boxes[1]).ok());
  ASSERT_TRUE(engine.update().ok());
  ASSERT_TRUE(engine.move(0, boxes[0]).ok());
  ASSERT_TRUE(engine.update().ok());
  // A few hundred kilobytes are kept whatever the world, more or less by how many threads were worth waking.
  EXPECT_LE(engine.statistics().bytes, full / 4 + 250'000);
  EXPECT_TRUE(is_exact(engine, {boxes.begin(), boxes.begin() + 100}));
}

}  // namespace
}  // namespace cellsweep::stream
