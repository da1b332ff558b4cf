/// @file
/// The same calls give the same lists in the same order, whatever the thread count and whoever else is at
/// work.
#include <array>
#include <deque>
#include <string>
#include <thread>
#include <vector>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random_caller.h"
#include "every_engine.h"

namespace cellsweep::contract {
namespace {

constexpr std::size_t kBodiesOfRuns = effort(60, 40, 20);
constexpr std::uint64_t kSeed = 7;
constexpr int kStepsOfRuns = effort(15, 5, 3);

/// The answers to one random sequence of calls, in the engine's own order.
std::vector<Answer> answers_of(const ContractEngine& engine, const BoxKind& kind) {
  CheckedEngine checked(engine, story_of(kind, kBodiesOfRuns, kSeed));
  RandomCaller caller(checked, kind, kBodiesOfRuns, kSeed);
  std::vector<Answer> answers;
  testing::AssertionResult good = caller.fill();
  for (int step = 0; good && step < kStepsOfRuns; ++step) {
    good = caller.step();
    answers.push_back(checked.answer());
  }
  EXPECT_TRUE(good);
  return answers;
}

ContractEngine with_threads(const ContractEngine& engine, unsigned threads) {
  const std::string number = std::to_string(threads);
  return engine_with_settings(engine.name, {{"threads", number}}, engine.label + "_threads_" + number);
}

using ThreadCountContract = PerEngineAndKind;

TEST_P(ThreadCountContract, TheThreadCountChangesNoListAndNoOrder) {
  const auto& [engine, kind] = GetParam();
  const std::vector<Answer> reference = answers_of(engine, kind);
  for (unsigned threads = 1; threads <= effort(4U, 2U); ++threads) {
    EXPECT_TRUE(reference == answers_of(with_threads(engine, threads), kind)) << threads << " threads";
  }
}

/// The engines of the table that can be told how many threads to use.
std::vector<ContractEngine> engines_with_threads() {
  std::vector<ContractEngine> engines;
  for (const EngineInfo& info : every_engine()) {
    if (!has_setting(info, "threads")) continue;
    engines.push_back(engine_with_settings(std::string(info.name), {}, label_of(info.name)));
  }
  return engines;
}

INSTANTIATE_TEST_SUITE_P(Engines, ThreadCountContract,
                         testing::Combine(testing::ValuesIn(engines_with_threads()), all_kinds()),
                         engine_and_kind_label);

using DeterminismContract = PerEngineAndKind;

TEST_P(DeterminismContract, TwoEnginesCalledInTurnAnswerAlike) {
  const auto& [engine, kind] = GetParam();
  CheckedEngine first(engine, "the first of two, " + story_of(kind, kBodiesOfRuns, kSeed));
  CheckedEngine second(engine, "the second of two, " + story_of(kind, kBodiesOfRuns, kSeed));
  RandomCaller first_caller(first, kind, kBodiesOfRuns, kSeed);
  RandomCaller second_caller(second, kind, kBodiesOfRuns, kSeed);
  ASSERT_TRUE(first_caller.fill());
  ASSERT_TRUE(second_caller.fill());
  for (int step = 0; step < kStepsOfRuns; ++step) {
    ASSERT_TRUE(first_caller.step());
    ASSERT_TRUE(second_caller.step());
    ASSERT_TRUE(first.answer() == second.answer()) << "step " << step;
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, DeterminismContract, all_engines_and_kinds(), engine_and_kind_label);

using IndependenceContract = PerEngine;

TEST_P(IndependenceContract, EnginesOnFourThreadsDoNotDisturbEachOther) {
  const BoxKind& kind = box_kind("touching");
  const std::vector<Answer> alone = answers_of(GetParam(), kind);
  std::array<std::vector<Answer>, 4> together;
  std::deque<std::jthread> threads;
  for (std::vector<Answer>& answers : together) {
    threads.emplace_back([&] { answers = answers_of(GetParam(), kind); });
  }
  threads.clear();
  for (const std::vector<Answer>& answers : together) EXPECT_TRUE(answers == alone);
}

INSTANTIATE_TEST_SUITE_P(Engines, IndependenceContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
