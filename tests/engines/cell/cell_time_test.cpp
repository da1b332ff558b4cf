// The Cell engines on a Cell's clock: which step a function belongs to, and that a frame's time is the same
// in every run.
#include <gtest/gtest.h>

#include "cellsweep/engines.h"
#include "cellsweep/world/scene.h"
#include "engines/cell/ppu/step_cycles.h"
#include "report/run_engine.h"

namespace cellsweep::cell {
namespace {

using report::CellFrame;

TEST(StepCycles, TellAStepByTheNameOfTheFunction) {
  const std::vector<FunctionCycles> functions = {
      {"cellsweep::cell::paper::intervector_sort(float*, unsigned int*)", 100, 0},
      {"cellsweep::cell::paper::(anonymous namespace)::insert_from(float*)", 20, 0},
      {"cellsweep::cell::paper::compare_changes(cellsweep::cell::paper::BeforeAndAfter const&)", 7, 0},
      {"(anonymous namespace)::compact(cellsweep::cell::paper::AxisStore&) [clone .isra.0]", 11, 1},
      {"void cellsweep::cell::paper::walk_overlaps<cellsweep::cell::paper::KeyStream>(unsigned int const*)",
       40, 0},
      {"cellsweep::cell::paper::KeyStream::~KeyStream()", 2, 0},
      {"main", 30, 25},
      {"intervector_sort_of_somebody_else", 5, 0}};
  EXPECT_EQ(cycles_by_step(functions), (StepCycles{120, 7, 10, 42, 26, 10}));
}

TEST(StepCycles, BecomeMicrosecondsBetweenTwoMoments) {
  const SpeTime time = spe_time({3300, 0, 0, 10, 6400, 3}, {100, 0, 0, 10, 3200, 5}, 3.2e9);
  EXPECT_DOUBLE_EQ(time.sort, 1);
  EXPECT_DOUBLE_EQ(time.overlap, 0);
  EXPECT_DOUBLE_EQ(time.dma_wait, 1);
  EXPECT_DOUBLE_EQ(time.other, 3 / 3200.0) << "a count that went back began at 0";
  EXPECT_DOUBLE_EQ(time.total(), 2 + 3 / 3200.0);
}

EngineOptions timed() {
  return {.spe_engine = SpeEngine::isa, .cycles = true};
}

/// Frame 0 and five more of a small scene.
std::vector<CellFrame> run(const char* name, const EngineOptions& options, double moving = 0.5) {
  auto engine = make_engine(name, options);
  SceneSettings scene;
  scene.bodies = 48;
  scene.moving = moving;
  auto source = make_scene_frames(scene);
  if (!engine || !source) return {};
  const auto report = report::run_engine(**engine, **source, {.updates = 5, .report_frames = {}});
  return report ? report->cell : std::vector<CellFrame>();
}

class CellTime : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!make_engine(GetParam(), timed())) GTEST_SKIP() << "built without the SPU compiler";
  }
};

void expect_same(const std::vector<CellFrame>& one, const std::vector<CellFrame>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].spes.size(), other[i].spes.size());
    for (std::size_t k = 0; k < one[i].spes.size(); ++k) {
      EXPECT_EQ(one[i].spes[k].total(), other[i].spes[k].total()) << "frame " << i << " SPE " << k;
      EXPECT_EQ(one[i].spes[k].dma_wait, other[i].spes[k].dma_wait) << "frame " << i << " SPE " << k;
    }
  }
}

TEST_P(CellTime, IsTheSameInEveryRunAndDmaMode) {
  const std::vector<CellFrame> once = run(GetParam(), timed());
  ASSERT_EQ(once.size(), 6U);
  ASSERT_EQ(once.front().spes.size(), 3U);
  EXPECT_GT(once.front().longest_us(), 1);
  expect_same(once, run(GetParam(), timed()));
  EngineOptions late = timed();
  late.dma = DmaMode::late;
  expect_same(once, run(GetParam(), late));
}

TEST_P(CellTime, HasMemorySharedByTheSpesUnlessToldOtherwise) {
  EngineOptions alone = timed();
  alone.cycle_parameters = {"sharing_spes=1"};
  EngineOptions three = timed();
  three.cycle_parameters = {"sharing_spes=3"};
  const std::vector<CellFrame> as_used = run(GetParam(), timed());
  ASSERT_FALSE(as_used.empty());
  expect_same(as_used, run(GetParam(), three));
  EXPECT_LT(run(GetParam(), alone).front().longest_us(), as_used.front().longest_us());
}

TEST_P(CellTime, IsNotThereUnlessAskedFor) {
  EXPECT_TRUE(run(GetParam(), {.spe_engine = SpeEngine::isa}).empty());
}

INSTANTIATE_TEST_SUITE_P(Engines, CellTime, testing::Values("cell-paper", "cell-brute", "cell-resident"),
                         [](const auto& each) { return std::string(each.param).substr(5); });

TEST(CellTimeOfPaper, HasEveryStepAndLittleElse) {
  const std::vector<CellFrame> frames = run("cell-paper", timed());
  if (frames.empty()) GTEST_SKIP() << "built without the SPU compiler";
  for (const SpeTime& spe : frames.front().spes) {
    for (const double step : {spe.sort, spe.change_detection, spe.compaction, spe.overlap, spe.dma_wait})
      EXPECT_GT(step, 0.1);
    EXPECT_LT(spe.other, 0.2 * spe.total()) << "a step's function is not known by its name";
  }
  EXPECT_TRUE(frames.back().threads_started);
}

TEST(CellTimeOfResident, IsMostlySortAndOverlapAndNothingForAStillFrame) {
  const std::vector<CellFrame> frames = run("cell-resident", timed());
  if (frames.empty()) GTEST_SKIP() << "built without the SPU compiler";
  for (const SpeTime& spe : frames.back().spes) EXPECT_LT(spe.other, 0.2 * spe.total());
  EXPECT_FALSE(frames.back().threads_started);
  EXPECT_EQ(run("cell-resident", timed(), 0).back().longest_us(), 0);
}

TEST(CellTimeSettings, AreRefusedInWords) {
  const auto without_isa = make_engine("cell-paper", {.cycles = true});
  ASSERT_FALSE(without_isa);
  EXPECT_EQ(without_isa.status().code, StatusCode::bad_option);
  EXPECT_NE(without_isa.status().message.find("spe_engine isa"), std::string::npos);
  EngineOptions wrong = timed();
  wrong.cycle_parameters = {"no_such=1"};
  EXPECT_FALSE(make_engine("cell-paper", wrong));
}

}  // namespace
}  // namespace cellsweep::cell
