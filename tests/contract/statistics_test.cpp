/// @file
/// What engines tell about themselves.
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <thread>
#include <vector>

#include "contract/contract_fixture.h"

namespace cellsweep::contract {
namespace {

using StatisticsContract = PerEngine;

void expect_sensible(const Statistics& statistics) {
  std::set<std::string_view> names;
  for (const Phase& phase : statistics.phases) {
    EXPECT_FALSE(phase.name.empty());
    EXPECT_TRUE(names.insert(phase.name).second) << "two phases are called " << phase.name;
    EXPECT_TRUE(std::isfinite(phase.milliseconds) && phase.milliseconds >= 0)
        << phase.name << " took " << phase.milliseconds << " ms";
  }
  for (const Counter& counter : statistics.counters) {
    EXPECT_FALSE(counter.name.empty());
    EXPECT_TRUE(names.insert(counter.name).second) << "two numbers are called " << counter.name;
  }
}

TEST_P(StatisticsContract, EveryUpdateCountsAndNamesWhatItDid) {
  Broadphase engine = make(GetParam());
  for (BodyId body = 0; body < 4; ++body) {
    ASSERT_TRUE(engine.insert(body, Aabb{{0, 0, 0}, {1, 1, 1}}).ok());
    EXPECT_EQ(engine.statistics().updates, body) << "no update yet";
    ASSERT_TRUE(engine.update().ok());
    EXPECT_EQ(engine.statistics().updates, body + 1);
    EXPECT_FALSE(engine.statistics().phases.empty());
    EXPECT_GT(engine.statistics().bytes, 0U);
    expect_sensible(engine.statistics());
  }
}

TEST_P(StatisticsContract, NumbersKeepTheirNamesFromUpdateToUpdate) {
  Broadphase engine = make(GetParam());
  const auto names = [&] {
    std::vector<std::string> all;
    for (const Counter& counter : engine.statistics().counters) all.emplace_back(counter.name);
    return all;
  };
  ASSERT_TRUE(engine.update().ok());
  const std::vector<std::string> first = names();
  ASSERT_TRUE(engine.insert(1, Aabb{}).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(names(), first);
}

// What they say is put together when somebody asks.
TEST_P(StatisticsContract, AreTheSameForAllThatAskAtTheSameTime) {
  Broadphase engine = make(GetParam());
  ASSERT_TRUE(engine.insert(1, Aabb{{0, 0, 0}, {1, 1, 1}}).ok());
  ASSERT_TRUE(engine.insert(2, Aabb{{0, 0, 0}, {1, 1, 1}}).ok());
  for (int update = 0; update < 3; ++update) {
    ASSERT_TRUE(engine.move(2, Aabb{{0, 0, 0}, {1, 1, 2 + static_cast<float>(update)}}).ok());
    ASSERT_TRUE(engine.update().ok());
    std::array<std::uint64_t, 4> bytes{};
    std::vector<std::thread> threads;
    for (std::uint64_t& of_one : bytes) {
      threads.emplace_back([&] {
        EXPECT_EQ(engine.pairs().size(), 1U);
        of_one = engine.statistics().bytes;
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_GT(bytes[0], 0U);
    for (const std::uint64_t of_one : bytes) EXPECT_EQ(of_one, bytes[0]);
    EXPECT_EQ(engine.statistics().bytes, bytes[0]);
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, StatisticsContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
