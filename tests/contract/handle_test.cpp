/// @file
/// A broadphase as a value: moved about with calls that no update has seen, and asked by several threads.
#include <gmock/gmock.h>

#include <algorithm>
#include <barrier>
#include <deque>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random_caller.h"

namespace cellsweep::contract {
namespace {

/// A box with edge 1 whose lower corner is at (x, 0, 0).
TEST(DefaultBroadphase, IsStreamAndReadyForUse) {
  Broadphase broadphase;
  EXPECT_EQ(broadphase.name(), "stream");
  ASSERT_TRUE(broadphase.insert(1, cube_at(0)).ok());
  ASSERT_TRUE(broadphase.insert(2, cube_at(1)).ok());
  const auto changes = broadphase.update();
  ASSERT_TRUE(changes.ok());
  EXPECT_THAT(changes->began, testing::ElementsAre(Pair{1, 2}));
}

TEST(DefaultBroadphase, MayHoldAnotherEngineLater) {
  std::optional<Broadphase> first(std::in_place);
  ASSERT_TRUE(first->insert(1, cube_at(0)).ok());
  *first = std::move(*make_broadphase(OracleOptions{}));
  EXPECT_EQ(first->name(), "oracle");
  EXPECT_EQ(first->size(), 0U);
  Broadphase second;
  second = std::move(*first);
  EXPECT_EQ(second.name(), "oracle");
  *first = Broadphase();
  EXPECT_EQ(first->name(), "stream") << "what was moved from may be assigned to";
}

class HandleContract : public PerEngine {
 protected:
  void move_by_construction() {
    Broadphase elsewhere(std::move(checked_.handle()));
    checked_.handle() = std::move(elsewhere);
  }

  /// What stood in its place before is forgotten.
  void move_by_assignment() {
    Broadphase elsewhere = make(GetParam());
    ASSERT_TRUE(elsewhere.insert(1, cube_at(50)).ok());
    ASSERT_TRUE(elsewhere.update().ok());
    elsewhere = std::move(checked_.handle());
    checked_.handle() = std::move(elsewhere);
  }

  CheckedEngine checked_{GetParam(), "moved about"};
};

TEST_P(HandleContract, ItGoesOnElsewhereWithEverythingThatItRemembers) {
  RandomCaller caller(checked_, box_kind("touching"), 20, 5);
  ASSERT_TRUE(caller.fill());
  move_by_construction();
  for (int step = 0; step < 6; ++step) {
    ASSERT_TRUE(caller.step());
    ASSERT_TRUE(caller.calls());
    move_by_construction();
    ASSERT_TRUE(caller.calls());
    move_by_assignment();
  }
  ASSERT_TRUE(checked_.update());
}

TEST_P(HandleContract, WhatItHandedOutStaysWhereItIs) {
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0), cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  const std::span<const Pair> pairs = checked_.engine().pairs();
  Broadphase elsewhere(std::move(checked_.handle()));
  EXPECT_THAT(pairs, testing::ElementsAre(Pair{1, 2}));
  EXPECT_EQ(elsewhere.pairs().data(), pairs.data());
  checked_.handle() = std::move(elsewhere);
}

TEST_P(HandleContract, SeveralLiveInAVector) {
  std::vector<Broadphase> all;
  for (BodyId id = 0; id < 5; ++id) {
    all.push_back(make(GetParam()));
    ASSERT_TRUE(all.back().insert(id, cube_at(0)).ok());
    ASSERT_TRUE(all.back().insert(100, cube_at(1)).ok());
  }
  std::ranges::reverse(all);
  for (BodyId id = 0; id < 5; ++id) {
    const auto changes = all[4 - id].update();
    ASSERT_TRUE(changes.ok());
    EXPECT_THAT(changes->began, testing::ElementsAre(Pair{id, 100}));
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, HandleContract, all_engines(), engine_label);

/// Everything that may be asked without changing anything.
struct Asked {
  std::vector<Pair> pairs;
  std::vector<Aabb> boxes;
  std::vector<bool> held;
  std::size_t size = 0;
  std::uint64_t updates = 0;
  std::uint64_t room = 0;
  bool boxes_are_there = false;

  friend bool operator==(const Asked&, const Asked&) = default;
};

Asked ask(const Broadphase& engine, const std::vector<BodyId>& ids) {
  Asked asked;
  asked.boxes.resize(ids.size());
  asked.boxes_are_there = engine.boxes(ids, asked.boxes).ok();
  asked.pairs.assign(engine.pairs().begin(), engine.pairs().end());
  for (const BodyId id : ids) asked.held.push_back(engine.contains(id));
  asked.size = engine.size();
  asked.updates = engine.statistics().updates;
  asked.room = engine.capacity().bodies;
  return asked;
}

/// The answers of threads that ask at the same time.
std::vector<Asked> ask_together(const Broadphase& engine, const std::vector<BodyId>& ids) {
  std::vector<Asked> answers(4);
  std::barrier start(static_cast<std::ptrdiff_t>(answers.size()));
  std::deque<std::jthread> threads;
  for (Asked& answer : answers) {
    threads.emplace_back([&] {
      start.arrive_and_wait();
      answer = ask(engine, ids);
    });
  }
  threads.clear();
  return answers;
}

using ConcurrentReadsContract = PerEngine;

TEST_P(ConcurrentReadsContract, SeveralThreadsMayAskAtTheSameTime) {
  CheckedEngine checked(GetParam(), "asked by several threads");
  // Nobody has asked for the pairs when the threads do.
  checked.look_at_pairs(false);
  RandomCaller caller(checked, box_kind("touching"), 60, 11);
  ASSERT_TRUE(caller.fill());
  for (int step = 0; step < effort(8, 3); ++step) {
    ASSERT_TRUE(checked.update());
    ASSERT_TRUE(caller.calls());
    std::vector<BodyId> ids;
    for (const auto& [id, box] : checked.model().shown) ids.push_back(id);
    const std::vector<Asked> answers = ask_together(checked.engine(), ids);
    EXPECT_TRUE(answers[0].boxes_are_there);
    EXPECT_EQ(answers[0].pairs, checked.model().pairs);
    EXPECT_EQ(answers[0].size, checked.model().boxes.size());
    for (const Asked& answer : answers) EXPECT_TRUE(answer == answers[0]);
    EXPECT_TRUE(ask(checked.engine(), ids) == answers[0]);
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, ConcurrentReadsContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
