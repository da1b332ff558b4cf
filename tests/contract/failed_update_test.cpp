/// @file
/// An update that finds more pairs than there may be leaves everything as it was, and the next one succeeds.
#include <gmock/gmock.h>

#include <algorithm>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/executors.h"
#include "contract/random_caller.h"
#ifdef CELLSWEEP_HAS_CELL
#include "cellsweep/cell.h"
#endif

namespace cellsweep::contract {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// An engine that can be told how many pairs there may be.
struct LimitedEngine {
  const char* label;
  Result<Broadphase> (*make)(std::uint64_t max_pairs);
};

std::ostream& operator<<(std::ostream& out, const LimitedEngine& engine) {
  return out << engine.label;
}

constexpr LimitedEngine kLimitedEngines[] = {
    {"stream", [](std::uint64_t pairs) { return make_broadphase(StreamOptions{.max_pairs = pairs}); }},
    {"stream_with_three_threads",
     [](std::uint64_t pairs) { return make_broadphase(StreamOptions{.threads = 3, .max_pairs = pairs}); }},
    {"stream_with_an_executor",
     [](std::uint64_t pairs) {
       return make_broadphase(StreamOptions{
           .threads = kConcurrency, .executor = std::make_shared<ReversingExecutor>(), .max_pairs = pairs});
     }},
#ifdef CELLSWEEP_HAS_CELL
    {"cell_stream",
     [](std::uint64_t pairs) { return make_broadphase(CellStreamOptions{.stream = {.max_pairs = pairs}}); }},
#endif
};

class FailedUpdateContract : public testing::TestWithParam<LimitedEngine> {
 protected:
  CheckedEngine limited_to(std::uint64_t max_pairs) const {
    return {std::move(*GetParam().make(max_pairs)), std::string(GetParam().label) + " with a limit of pairs"};
  }
};

/// Refused for more than so many pairs, in words.
void expect_too_many_pairs(const Status& status, std::uint64_t limit) {
  EXPECT_EQ(status.code, StatusCode::capacity) << status.message;
  EXPECT_EQ(status.setting, "max_pairs");
  EXPECT_EQ(status.limit, limit);
  EXPECT_GT(status.number, limit);
  EXPECT_THAT(status.message, testing::AllOf(HasSubstr("max_pairs"), HasSubstr(std::to_string(limit))));
}

TEST_P(FailedUpdateContract, TheFirstUpdateMayFailAndThereAreNoPairs) {
  CheckedEngine checked = limited_to(2);
  Status status;
  ASSERT_TRUE(checked.insert({1, 2, 3}, std::vector<Aabb>(3, cube_at(0))));
  ASSERT_TRUE(checked.refuse_update(status));
  expect_too_many_pairs(status, 2);
  ASSERT_TRUE(checked.move({3}, {cube_at(9)}));
  ASSERT_TRUE(checked.update());
  EXPECT_THAT(checked.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(FailedUpdateContract, StatisticsAreThoseOfTheBodiesUntilOneSucceeds) {
  Broadphase engine = std::move(*GetParam().make(2));
  ASSERT_TRUE(engine.insert(std::vector<BodyId>{1, 2}, std::vector<Aabb>(2, cube_at(0))).ok());
  ASSERT_TRUE(engine.update().ok());
  const std::uint64_t bytes = engine.statistics().bytes;
  ASSERT_TRUE(engine.insert(3, cube_at(0)).ok());
  ASSERT_FALSE(engine.update().ok());
  EXPECT_EQ(engine.statistics().updates, 1U);
  EXPECT_GT(engine.statistics().bytes, 0U);
  EXPECT_LT(engine.statistics().bytes, bytes) << "the engine is thrown away";
  ASSERT_TRUE(engine.move(3, cube_at(9)).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(engine.statistics().updates, 2U);
  EXPECT_GE(engine.statistics().bytes, bytes);
}

TEST_P(FailedUpdateContract, AsManyPairsAsThereMayBeAreFine) {
  CheckedEngine checked = limited_to(3);
  ASSERT_TRUE(checked.insert({1, 2, 3}, std::vector<Aabb>(3, cube_at(0))));
  ASSERT_TRUE(checked.update());
  EXPECT_EQ(checked.answer().pairs.size(), 3U);
}

TEST_P(FailedUpdateContract, PairsBoxesAndCallsOutliveItAndTheNextUpdateTellsTheWholeDifference) {
  CheckedEngine checked = limited_to(4);
  ASSERT_TRUE(checked.insert(
      {1, 2, 3, 4, 5, 6}, {cube_at(0), cube_at(0.5F), cube_at(9), cube_at(20), cube_at(30), cube_at(30.5F)}));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.move({3, 4}, {cube_at(0), cube_at(0)}));
  ASSERT_TRUE(checked.insert({7}, {cube_at(0)}));
  ASSERT_TRUE(checked.remove({2}));
  ASSERT_TRUE(checked.remove({5}));
  ASSERT_TRUE(checked.insert({5}, {cube_at(30)}));
  Status status;
  for (int attempt = 0; attempt < 3; ++attempt) {
    ASSERT_TRUE(checked.refuse_update(status));
    expect_too_many_pairs(status, 4);
    EXPECT_THAT(checked.engine().pairs(), ElementsAre(Pair{1, 2}, Pair{5, 6}));
  }
  std::vector<BodyId> added;
  ASSERT_TRUE(checked.add({cube_at(30)}, added));
  EXPECT_THAT(added, ElementsAre(8U)) << "the ids of bodies in pairs are still taken";
  ASSERT_TRUE(checked.refuse_update(status));
  ASSERT_TRUE(checked.move({3, 4}, {cube_at(40), cube_at(50)}));
  ASSERT_TRUE(checked.update());
  EXPECT_THAT(checked.answer().ended, ElementsAre(Pair{1, 2}, Pair{5, 6}));
  EXPECT_THAT(checked.answer().began, ElementsAre(Pair{1, 7}, Pair{5, 6}, Pair{5, 8}, Pair{6, 8}));
}

TEST_P(FailedUpdateContract, RemovingBodiesHelpsToo) {
  CheckedEngine checked = limited_to(3);
  const std::vector<BodyId> ids = {4, 1, 3, 2};
  ASSERT_TRUE(checked.insert(ids, {cube_at(0), cube_at(9), cube_at(20), cube_at(30)}));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.move(ids, std::vector<Aabb>(4, cube_at(0))));
  Status status;
  ASSERT_TRUE(checked.refuse_update(status));
  ASSERT_TRUE(checked.remove({3}));
  ASSERT_TRUE(checked.update());
  EXPECT_THAT(checked.answer().began, ElementsAre(Pair{1, 2}, Pair{1, 4}, Pair{2, 4}));
}

TEST_P(FailedUpdateContract, WhetherOneFailsDependsOnThePairsAlone) {
  for (const char* name : {"uniform", "touching", "columns", "identical"}) {
    const BoxKind& kind = box_kind(name);
    constexpr std::size_t kLimits[] = {0, 20, 60, 200};
    for (const std::size_t limit : kLimits) {
      CheckedEngine checked = limited_to(limit);
      RandomCaller caller(checked, kind, 40, limit + 1);
      ASSERT_TRUE(caller.fill());
      for (int step = 0; step < effort(20, 10, 4); ++step) {
        const bool too_many = limit != 0 && checked.model().brute_force().size() > limit;
        Status status;
        ASSERT_TRUE(too_many ? checked.refuse_update(status) : checked.update()) << kind.name;
        if (too_many) expect_too_many_pairs(status, limit);
        ASSERT_TRUE(caller.calls());
      }
      ASSERT_TRUE(checked.remove(checked.model().ids()));
      ASSERT_TRUE(checked.update());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, FailedUpdateContract, testing::ValuesIn(kLimitedEngines),
                         [](const auto& test) { return std::string(test.param.label); });

}  // namespace
}  // namespace cellsweep::contract
