/// @file
/// Bodies whose ids say nothing: scattered over all that there are, and met in no order.
#include <algorithm>
#include <set>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random_caller.h"

namespace cellsweep::contract {
namespace {

/// Different ids from all 32 bits, the first and the last among them, in random order.
std::vector<BodyId> scattered_ids(Random& random, std::size_t count) {
  std::set<BodyId> ids = {0, 0xffffffff};
  while (ids.size() < count) ids.insert(static_cast<BodyId>(random.bits()));
  std::vector<BodyId> all(ids.begin(), ids.end());
  random.shuffle(all);
  return all;
}

/// Inserts, moves and removes, each time in another order, and the same bodies again.
class ScatteredLife {
 public:
  ScatteredLife(CheckedEngine& checked, const BoxKind& kind, std::size_t bodies, std::uint64_t seed)
      : checked_(checked), kind_(kind), random_(seed), ids_(scattered_ids(random_, bodies)) {}

  void live() {
    ASSERT_TRUE(insert(ids_));
    for (int round = 0; round < effort(3, 2, 1); ++round) {
      ASSERT_TRUE(checked_.update());
      ASSERT_TRUE(move(part()));
      ASSERT_TRUE(checked_.update());
      const std::vector<BodyId> gone = part();
      ASSERT_TRUE(checked_.remove(gone));
      ASSERT_TRUE(move(checked_.model().ids()));
      ASSERT_TRUE(checked_.update());
      ASSERT_TRUE(insert(gone));
      ASSERT_TRUE(checked_.update());
      // The same ids are other bodies now.
      const std::vector<BodyId> replaced = part();
      ASSERT_TRUE(checked_.remove(replaced));
      ASSERT_TRUE(insert(shuffled(replaced)));
    }
    ASSERT_TRUE(checked_.update());
    ASSERT_TRUE(checked_.remove(shuffled(ids_)));
    ASSERT_TRUE(checked_.update());
    ASSERT_TRUE(insert(shuffled(ids_)));
    ASSERT_TRUE(checked_.update());
  }

 private:
  std::vector<BodyId> shuffled(std::vector<BodyId> ids) {
    random_.shuffle(ids);
    return ids;
  }

  std::vector<BodyId> part() {
    std::vector<BodyId> ids = shuffled(ids_);
    ids.resize(1 + random_.below(ids.size()));
    return ids;
  }

  testing::AssertionResult insert(const std::vector<BodyId>& ids) {
    return checked_.insert(ids, make_boxes(kind_, random_, ids.size()));
  }

  testing::AssertionResult move(const std::vector<BodyId>& ids) {
    return checked_.move(ids, make_boxes(kind_, random_, ids.size()));
  }

  CheckedEngine& checked_;
  const BoxKind& kind_;
  Random random_;
  std::vector<BodyId> ids_;
};

using ScatteredIdsContract = PerEngineAndKind;

TEST_P(ScatteredIdsContract, EveryUpdateEqualsTheOracle) {
  const auto& [engine, kind] = GetParam();
  for (const std::size_t wanted : {std::size_t{7}, std::size_t{effort(90, 60, 20)}}) {
    CheckedEngine checked(engine, story_of(kind, wanted, wanted));
    ScatteredLife(checked, kind, std::min(wanted, checked.capacity()), wanted).live();
    if (HasFatalFailure()) return;
  }
}

using ScatteredIdsAnewContract = PerEngine;

TEST_P(ScatteredIdsAnewContract, AllMayGoAndComeBackInAnotherOrder) {
  const BoxKind& kind = box_kind("touching");
  for (const std::size_t bodies : {5, 16}) {
    CheckedEngine checked(GetParam(), story_of(kind, bodies, 1));
    Random random(bodies);
    std::vector<BodyId> ids = scattered_ids(random, bodies);
    for (int round = 0; round < 6; ++round) {
      ASSERT_TRUE(checked.insert(ids, make_boxes(kind, random, bodies)));
      ASSERT_TRUE(checked.update());
      random.shuffle(ids);
      ASSERT_TRUE(checked.remove(ids));
      if (round % 2 == 0) {
        ASSERT_TRUE(checked.update());
      }
      random.shuffle(ids);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, ScatteredIdsAnewContract, all_engines(), engine_label);

INSTANTIATE_TEST_SUITE_P(Engines, ScatteredIdsContract, all_engines_and_kinds(), engine_and_kind_label);

}  // namespace
}  // namespace cellsweep::contract
