// The Cell engines on a Cell's clock: which step a function belongs to, and that a frame's time is the same
// in every run.
#include <gtest/gtest.h>

#include "cellsweep/world/scene.h"
#include "engines/cell/cell_world.h"
#include "engines/cell/ppu/step_cycles.h"

namespace cellsweep::cell {
namespace {

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

SpeOptions timed() {
  return {.spe_engine = SpeEngine::isa, .cycles = true};
}

/// The longest of the SPEs, in microseconds.
double longest(const CellTime& time) {
  double longest = 0;
  for (const SpeTime& spe : time.spes) longest = std::max(longest, spe.total());
  return longest;
}

/// Frame 0 and five more of a small scene; nothing when the engine cannot be had or does not count.
std::vector<CellTime> run(const NamedEngine& named, const SpeOptions& spes, double moving = 0.5) {
  auto engine = named.make(spes);
  SceneSettings scene;
  scene.bodies = 48;
  scene.moving = moving;
  auto source = make_scene_frames(scene);
  if (!engine || !source) return {};
  EXPECT_TRUE(insert_all(*engine, **source).ok());
  std::vector<CellTime> times;
  for (int frame = 0; frame < 6; ++frame) {
    if (frame > 0) {
      (*source)->advance();
      EXPECT_TRUE(move_changed(*engine, **source).ok());
    }
    EXPECT_TRUE(engine->update().ok());
    const auto statistics = cell_statistics(*engine);
    if (statistics && statistics->time) times.push_back(*statistics->time);
  }
  return times;
}

class CellTimeOf : public testing::TestWithParam<NamedEngine> {
 protected:
  void SetUp() override {
    if (!GetParam().make(timed())) GTEST_SKIP() << "built without the SPU compiler";
  }
};

void expect_same(const std::vector<CellTime>& one, const std::vector<CellTime>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].spes.size(), other[i].spes.size());
    for (std::size_t k = 0; k < one[i].spes.size(); ++k) {
      EXPECT_EQ(one[i].spes[k].total(), other[i].spes[k].total()) << "frame " << i << " SPE " << k;
      EXPECT_EQ(one[i].spes[k].dma_wait, other[i].spes[k].dma_wait) << "frame " << i << " SPE " << k;
    }
  }
}

TEST_P(CellTimeOf, IsTheSameInEveryRunAndDmaMode) {
  const std::vector<CellTime> once = run(GetParam(), timed());
  ASSERT_EQ(once.size(), 6U);
  ASSERT_EQ(once.front().spes.size(), 3U);
  EXPECT_GT(longest(once.front()), 1);
  expect_same(once, run(GetParam(), timed()));
  SpeOptions late = timed();
  late.dma = DmaMode::late;
  expect_same(once, run(GetParam(), late));
}

TEST_P(CellTimeOf, HasMemorySharedByTheSpesUnlessToldOtherwise) {
  SpeOptions alone = timed();
  alone.cycle_parameter = {"sharing_spes=1"};
  SpeOptions three = timed();
  three.cycle_parameter = {"sharing_spes=3"};
  const std::vector<CellTime> as_used = run(GetParam(), timed());
  ASSERT_FALSE(as_used.empty());
  expect_same(as_used, run(GetParam(), three));
  EXPECT_LT(longest(run(GetParam(), alone).front()), longest(as_used.front()));
}

TEST_P(CellTimeOf, IsNotThereUnlessAskedFor) {
  EXPECT_TRUE(run(GetParam(), {.spe_engine = SpeEngine::isa}).empty());
}

TEST_P(CellTimeOf, SetsTheWaitForSpesAside) {
  const std::vector<CellTime> frames = run(GetParam(), timed());
  ASSERT_FALSE(frames.empty());
  EXPECT_GT(frames.front().set_aside_ms, 0);
}

INSTANTIATE_TEST_SUITE_P(Engines, CellTimeOf, testing::ValuesIn(kEngines),
                         [](const auto& test) { return test.param.name; });

TEST(CellTimeOfPaper, HasEveryStepAndLittleElse) {
  const std::vector<CellTime> frames = run(kEngines[0], timed());
  if (frames.empty()) GTEST_SKIP() << "built without the SPU compiler";
  for (const SpeTime& spe : frames.front().spes) {
    for (const double step : {spe.sort, spe.change_detection, spe.compaction, spe.overlap, spe.dma_wait})
      EXPECT_GT(step, 0.1);
    EXPECT_LT(spe.other, 0.2 * spe.total()) << "a step's function is not known by its name";
  }
  EXPECT_TRUE(frames.back().threads_started);
}

TEST(CellTimeOfResident, IsMostlySortAndOverlapAndNothingForAStillFrame) {
  const NamedEngine& resident = kEngines[2];
  const std::vector<CellTime> frames = run(resident, timed());
  if (frames.empty()) GTEST_SKIP() << "built without the SPU compiler";
  for (const SpeTime& spe : frames.back().spes) EXPECT_LT(spe.other, 0.2 * spe.total());
  EXPECT_FALSE(frames.back().threads_started);
  EXPECT_EQ(longest(run(resident, timed(), 0).back()), 0);
}

TEST(CellTimeSettings, AreRefusedInWords) {
  const Status without_isa = make_on<CellPaperOptions>({.cycles = true}).status();
  EXPECT_EQ(without_isa.code, StatusCode::bad_option);
  EXPECT_EQ(without_isa.setting, "cycles");
  EXPECT_NE(without_isa.message.find("spe_engine isa"), std::string::npos);
  SpeOptions wrong = timed();
  wrong.cycle_parameter = {"no_such=1"};
  EXPECT_FALSE(make_on<CellPaperOptions>(wrong));
  if (!make_on<CellPaperOptions>(timed())) GTEST_SKIP() << "built without the SPU compiler";
  EXPECT_EQ(make_on<CellPaperOptions>(wrong).status().setting, "cycle_parameter");
}

}  // namespace
}  // namespace cellsweep::cell
