/// @file
/// What cell_statistics() tells of engines on SPEs, and of others.
#include <gmock/gmock.h>

#include "engines/cell/cell_world.h"

namespace cellsweep::cell {
namespace {

using contract::Random;

class CellStatisticsOf : public testing::TestWithParam<NamedEngine> {
 protected:
  Broadphase engine_ = std::move(*GetParam().make({}));
};

TEST_P(CellStatisticsOf, AreThoseOfTheCountersForPeople) {
  Random random(1);
  ASSERT_TRUE(engine_.insert(ids_up_to(200), random_boxes(random, 200)).ok());
  ASSERT_TRUE(engine_.update().ok());
  const auto statistics = cell_statistics(engine_);
  ASSERT_TRUE(statistics.has_value());
  EXPECT_GT(statistics->dma_gets, 0U);
  EXPECT_EQ(statistics->dma_gets, counter(engine_, "dma gets"));
  EXPECT_EQ(statistics->dma_puts, counter(engine_, "dma puts"));
  EXPECT_EQ(statistics->dma_bytes_in, counter(engine_, "dma bytes in"));
  EXPECT_EQ(statistics->dma_bytes_out, counter(engine_, "dma bytes out"));
  EXPECT_EQ(statistics->local_store_high_water, counter(engine_, "local store high water"));
  EXPECT_FALSE(statistics->time.has_value()) << "not asked for";
  EXPECT_EQ(statistics->longest_spu_ms > 0, GetParam().name != "resident") << "its programs run on";
  EXPECT_GT(engine_.statistics().bytes, 0U);
}

TEST_P(CellStatisticsOf, AreThereBeforeTheFirstUpdate) {
  const auto statistics = cell_statistics(engine_);
  ASSERT_TRUE(statistics.has_value());
  EXPECT_EQ(statistics->dma_gets, 0U);
}

INSTANTIATE_TEST_SUITE_P(Engines, CellStatisticsOf, testing::ValuesIn(kEngines),
                         [](const auto& test) { return test.param.name; });

using PhasesOf = CellStatisticsOf;

TEST_P(PhasesOf, HaveOneOfTheSpes) {
  ASSERT_TRUE(engine_.insert(ids_up_to(2), std::vector<Aabb>{cube(0), cube(0.5F)}).ok());
  ASSERT_TRUE(engine_.update().ok());
  const auto& phases = engine_.statistics().phases;
  const auto of_kind = [&](PhaseKind kind) { return std::ranges::count(phases, kind, &Phase::kind); };
  EXPECT_EQ(of_kind(PhaseKind::spes), 1);
  EXPECT_EQ(of_kind(PhaseKind::setup), GetParam().name == "paper" ? 1 : 0);
}

// Those of cell-stream are those of engine stream.
INSTANTIATE_TEST_SUITE_P(Engines, PhasesOf, testing::Values(kEngines[0], kEngines[1], kEngines[2]),
                         [](const auto& test) { return test.param.name; });

TEST(CellStatisticsOfOthers, AreNone) {
  EXPECT_FALSE(cell_statistics(*make_broadphase(ControlOptions{})).has_value());
  EXPECT_FALSE(cell_statistics(Broadphase()).has_value());
}

TEST(CellStatisticsOfStream, AreThoseOfTheLastUpdateWhicheverKindItWas) {
  Broadphase engine = make(CellStreamOptions{});
  ASSERT_TRUE(engine.insert(ids_up_to(50), std::vector<Aabb>(50, cube(0))).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_GT(cell_statistics(engine)->longest_spu_ms, 0);
  const std::uint64_t gets = cell_statistics(engine)->dma_gets;
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(cell_statistics(engine)->longest_spu_ms, 0) << "nothing had changed";
  EXPECT_EQ(cell_statistics(engine)->dma_gets, gets);
}

TEST(CellStatisticsOfPaper, CountListElementsAndNoSpuTimeOfAnUpdateWithoutBodies) {
  Broadphase engine = make(CellPaperOptions{.list_dma = true});
  ASSERT_TRUE(engine.insert(ids_up_to(3), std::vector<Aabb>(3, cube(0))).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_GT(cell_statistics(engine)->dma_list_elements, 0U);
  ASSERT_TRUE(engine.remove(ids_up_to(3)).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(cell_statistics(engine)->longest_spu_ms, 0);
  EXPECT_EQ(counter(engine, "longest spu of this update, ns"), 0U);
}

}  // namespace
}  // namespace cellsweep::cell
