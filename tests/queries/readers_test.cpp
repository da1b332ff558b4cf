/// @file
/// Any number of threads may ask at a time, alone and in batches; who changes a broadphase meanwhile is
/// caught in debug builds.
#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "contract/random.h"
#include "queries/random_questions.h"

namespace cellsweep::queries {
namespace {

struct FilledWorld {
  explicit FilledWorld(std::size_t count) {
    contract::Random random(3);
    for (std::size_t i = 0; i < count; ++i) {
      const auto body = static_cast<BodyId>(random.bits());
      const Point at = {random.between(0, 25), random.between(0, 25), random.between(0, 25)};
      const Aabb box = {at, {at[0] + 1, at[1] + 1, at[2] + 1}};
      if (!truth.boxes.emplace(body, box).second) continue;
      EXPECT_TRUE(broadphase.insert(body, box).ok());
    }
    EXPECT_TRUE(broadphase.update().ok());
  }

  Broadphase broadphase = std::move(*make_broadphase(StreamOptions{.threads = 3}));
  Reference truth;
};

TEST(Readers, EightThreadsGetTheAnswersOfOne) {
  FilledWorld world(3000);
  std::atomic<int> wrong = 0;
  std::vector<std::thread> readers;
  for (std::uint64_t reader = 0; reader < 8; ++reader) {
    readers.emplace_back([&world, &wrong, reader] {
      for (std::uint64_t seed = 0; seed < 4; ++seed) {
        if (seed == 2) world.broadphase.queries().prepare();
        if (!answers_are_right(world.broadphase.queries(), world.truth, 10 * reader + seed)) ++wrong;
      }
    });
  }
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_TRUE(world.broadphase.update().ok());
}

// One of them brings the tree up to date, whoever it is.
TEST(Readers, EightThreadsGetTheAnswersOfOneAfterEachUpdate) {
  FilledWorld world(500);
  world.broadphase.queries().prepare();
  for (std::uint64_t round = 0; round < 12; ++round) {
    std::uint64_t left = round % 3 == 2 ? 400 : 5;
    for (auto& [body, box] : world.truth.boxes) {
      if (left-- == 0) break;
      box.max[0] += 0.25F;
      ASSERT_TRUE(world.broadphase.move(body, box).ok());
    }
    ASSERT_TRUE(world.broadphase.update().ok());
    std::atomic<int> wrong = 0;
    std::vector<std::thread> readers;
    for (std::uint64_t reader = 0; reader < 8; ++reader) {
      readers.emplace_back([&world, &wrong, seed = 10 * reader + round] {
        if (!answers_are_right(world.broadphase.queries(), world.truth, seed)) ++wrong;
      });
    }
    for (std::thread& reader : readers) reader.join();
    ASSERT_EQ(wrong, 0);
  }
}

TEST(Readers, WhatAPredicateThrowsLeavesTheQueryAndNothingElseHappens) {
  FilledWorld world(3000);
  const Queries queries = world.broadphase.queries();
  const QueryFilter throws{.as = {}, .predicate = [](BodyId) -> bool { throw std::runtime_error("no"); }};
  const std::vector<Region> regions(300, Region(Aabb{{0, 0, 0}, {25, 25, 25}}));
  BatchAnswers<BodyId> found;
  std::vector<BodyId> bodies;
  EXPECT_THROW(static_cast<void>(queries.find_overlaps(regions[0], bodies, throws)), std::runtime_error);
  EXPECT_THROW(static_cast<void>(queries.find_overlaps(regions, found, throws)), std::runtime_error);
  EXPECT_TRUE(answers_are_right(queries, world.truth, 1));
  EXPECT_TRUE(world.broadphase.update().ok());
}

#ifndef NDEBUG
TEST(ReadersDeathTest, AnUpdateWhileAQueryReadsIsCaught) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  FilledWorld world(20);
  const auto update = [&](BodyId) { return world.broadphase.update().ok(); };
  EXPECT_DEATH(
      static_cast<void>(world.broadphase.queries().visit_overlaps(Aabb{{0, 0, 0}, {25, 25, 25}}, update)),
      "changed while a query read it");
}
#endif

}  // namespace
}  // namespace cellsweep::queries
