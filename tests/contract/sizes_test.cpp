/// @file
/// Every kind of boxes at the sizes where vectors and blocks end, and at sizes that fill many of them.
#include <algorithm>
#include <cstdint>
#include <numeric>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random_caller.h"

namespace cellsweep::contract {
namespace {

std::vector<BodyId> first_ids(std::size_t count) {
  std::vector<BodyId> ids(count);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  return ids;
}

/// The life of a scene: all bodies at once, a standstill, a few moves, everything moves, a few are replaced
/// while others move, half of it goes and comes back, all goes.
void live_through(CheckedEngine& checked, const BoxKind& kind, std::size_t bodies, std::uint64_t seed) {
  Random random(seed);
  const std::vector<BodyId> ids = first_ids(bodies);
  const std::vector<BodyId> few(ids.begin(), ids.begin() + (bodies + 9) / 10);
  const std::vector<BodyId> half(ids.begin() + bodies / 2, ids.end());

  ASSERT_TRUE(checked.insert(ids, make_boxes(kind, random, bodies)));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.update());
  EXPECT_TRUE(checked.answer().began.empty() && checked.answer().ended.empty());
  ASSERT_TRUE(checked.move(few, make_boxes(kind, random, few.size())));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.move(ids, make_boxes(kind, random, bodies)));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.remove(few));
  ASSERT_TRUE(checked.insert(few, make_boxes(kind, random, few.size())));
  ASSERT_TRUE(checked.move(half, make_boxes(kind, random, half.size())));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.remove(half));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.insert(half, make_boxes(kind, random, half.size())));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.remove(ids));
  ASSERT_TRUE(checked.update());
  EXPECT_TRUE(checked.engine().pairs().empty());
}

std::vector<std::size_t> sizes() {
  if (kEmulated) return {0, 1, 4, 5, 17, 33};
  if (kPace == Pace::sanitized) return {0, 1, 3, 4, 5, 16, 17, 33, 150};
  return {0, 1, 2, 3, 4, 5, 15, 16, 17, 31, 32, 33, 64, 150};
}

using SizesContract = PerEngineAndKind;

TEST_P(SizesContract, EverySizeLivesFromTheFirstInsertToTheLastRemove) {
  const auto& [engine, kind] = GetParam();
  const std::vector<std::size_t> all = sizes();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_turn(i, turn_of(kind))) continue;
    const std::size_t wanted = all[i];
    CheckedEngine checked(engine, story_of(kind, wanted, wanted));
    live_through(checked, kind, std::min(wanted, checked.capacity()), wanted);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, SizesContract, all_engines_and_kinds(), engine_and_kind_label);

constexpr std::size_t kMany = effort(1024, 300, 150);
constexpr std::size_t kManyInLongForm = 1024;
/// Of an engine whose programs are interpreted, in the gate.
constexpr std::size_t kManyOfSlow = 300;
/// Two million pairs in the long form, which a sanitized build would take a minute an engine to sort and
/// compare.
constexpr std::size_t kManyIdentical = effort(1024, 300, 300);

class ManyBodiesContract : public PerEngine {
 protected:
  /// This many, or what the gate has time for or the engine holds.
  static std::size_t most(const CheckedEngine& checked, std::size_t wanted) {
    const std::size_t some =
        is_interpreted(GetParam()) ? repeated(wanted, std::min(wanted, kManyOfSlow)) : wanted;
    return std::min(some, checked.capacity());
  }
};

TEST_P(ManyBodiesContract, BodiesOfVeryDifferentSizesEqualTheOracle) {
  const BoxKind& kind = box_kind("very_different_sizes");
  CheckedEngine checked(GetParam(), story_of(kind, kMany, 1));
  live_through(checked, kind, most(checked, repeated(kManyInLongForm, kMany)), 1);
}

TEST_P(ManyBodiesContract, OneGiantAmongSmallBodiesEqualsTheOracle) {
  const BoxKind& kind = box_kind("one_giant");
  CheckedEngine checked(GetParam(), story_of(kind, kMany, 2));
  live_through(checked, kind, most(checked, repeated(kManyInLongForm, kMany)), 2);
}

TEST_P(ManyBodiesContract, IdenticalBodiesAllOverlap) {
  CheckedEngine checked(GetParam(), "many identical bodies");
  const std::size_t bodies = most(checked, repeated(2 * kManyIdentical, kManyIdentical));
  const std::vector<Aabb> boxes(bodies, Aabb{{1, 2, 3}, {4, 5, 6}});
  ASSERT_TRUE(checked.insert(first_ids(bodies), boxes));
  ASSERT_TRUE(checked.update());
  EXPECT_EQ(checked.engine().pairs().size(), bodies * (bodies - 1) / 2);
  ASSERT_TRUE(checked.move({0}, {Aabb{{9, 9, 9}, {9, 9, 9}}}));
  ASSERT_TRUE(checked.update());
  EXPECT_EQ(checked.answer().ended.size(), bodies - 1);
}

INSTANTIATE_TEST_SUITE_P(Engines, ManyBodiesContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
