/// @file
/// Random sequences of calls: after every update the engine has the oracle's pairs and tells the difference.
#include <cstdint>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random_caller.h"

namespace cellsweep::contract {
namespace {

constexpr std::size_t kBodies[] = {0, 1, 2, 3, 4, 5, 15, 16, 17, 33, 64};
constexpr int kSteps = effort(12, 3);

using SequencesContract = PerEngineAndKind;

TEST_P(SequencesContract, EveryUpdateEqualsTheOracle) {
  const auto& [engine, kind] = GetParam();
  const std::uint64_t seeds = repeated(4) * std::size(kBodies);
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    if (!is_turn(seed, turn_of(kind))) continue;
    const std::size_t bodies = kBodies[seed % std::size(kBodies)];
    CheckedEngine checked(engine, story_of(kind, bodies, seed));
    RandomCaller caller(checked, kind, bodies, seed);
    ASSERT_TRUE(caller.fill());
    for (int step = 0; step < kSteps; ++step) ASSERT_TRUE(caller.step());
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, SequencesContract, all_engines_and_kinds(), engine_and_kind_label);

}  // namespace
}  // namespace cellsweep::contract
