/// @file
/// Every engine answers queries as looking at each box does: after an update, and while changes wait for the
/// next one.
#include <cstdint>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random_caller.h"
#include "queries/random_questions.h"

namespace cellsweep::contract {
namespace {

constexpr std::size_t kAskedBodies[] = {0, 1, 2, 17, 64};
constexpr int kAskedSteps = effort(4, 2, 1);

using QueriesContract = PerEngineAndKind;

queries::Reference shown_by(const Model& model) {
  return {model.shown, model.filters};
}

TEST_P(QueriesContract, AnswersAreThoseOfLookingAtEachBox) {
  const auto& [engine, kind] = GetParam();
  const std::uint64_t seeds = repeated(3) * std::size(kAskedBodies);
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    if (!is_turn(seed, turn_of(kind))) continue;
    const std::size_t bodies = kAskedBodies[seed % std::size(kAskedBodies)];
    CheckedEngine checked(engine, story_of(kind, bodies, seed));
    RandomCaller caller(checked, kind, bodies, seed);
    ASSERT_TRUE(caller.fill());
    ASSERT_TRUE(queries::answers_are_right(checked.engine().queries(), {}, seed))
        << "before the first update";
    for (int step = 0; step < kAskedSteps; ++step) {
      ASSERT_TRUE(caller.step());
      if (step % 2 == 1) checked.engine().queries().prepare();
      const queries::Reference shown = shown_by(checked.model());
      const auto questions = seed * 1000 + static_cast<std::uint64_t>(step);
      ASSERT_TRUE(queries::answers_are_right(checked.engine().queries(), shown, questions))
          << story_of(kind, bodies, seed) << ", step " << step;
      ASSERT_TRUE(caller.calls());
      if (seed % 2 == 1) checked.engine().queries().prepare();
      ASSERT_TRUE(queries::answers_are_right(checked.engine().queries(), shown, questions))
          << story_of(kind, bodies, seed) << ", step " << step << ", with changes that wait";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, QueriesContract, all_engines_and_kinds(), engine_and_kind_label);

}  // namespace
}  // namespace cellsweep::contract
