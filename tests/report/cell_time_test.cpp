#include "report/cell_time.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cellsweep::report {
namespace {

using ::testing::HasSubstr;

CellFrame frame(std::size_t number, std::size_t moved, double sort) {
  SpeTime quick;
  quick.overlap = 1;
  SpeTime slow;
  slow.sort = sort;
  slow.dma_wait = 0.5;
  return {number, moved, {quick, slow}, 0.25, number % 2 == 0};
}

RunReport counted_run() {
  RunReport run;
  run.engine = "some-engine";
  run.cell = {frame(0, 9, 50), frame(1, 2, 30), frame(2, 0, 4), frame(3, 2, 10), frame(4, 2, 20)};
  return run;
}

TEST(CellRows, AreTheInitialFrameAndMedianAndLongestOfEachKind) {
  const RunReport run = counted_run();
  const std::vector<CellRow> rows = cell_rows(run);
  ASSERT_EQ(rows.size(), 5U);
  const std::size_t frames[] = {0, 2, 2, 4, 1};
  const char* kinds[] = {"initial", "static", "static", "dynamic", "dynamic"};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(rows[i].frame->frame, frames[i]);
    EXPECT_EQ(rows[i].kind, kinds[i]);
  }
  EXPECT_EQ(rows[3].which, "median");
  EXPECT_DOUBLE_EQ(rows[4].frame->longest_us(), 30.5);
}

TEST(CellRows, OfARunThatWasNotCountedAreNone) {
  EXPECT_TRUE(cell_rows(RunReport()).empty());
}

TEST(CellTables, ShowEverySpeAndTheHostsSideApart) {
  const std::vector<RunReport> runs = {counted_run()};
  const std::string text = cell_tables(runs, {4, 2000});
  EXPECT_THAT(text, HasSubstr("DMA wait"));
  EXPECT_THAT(text, HasSubstr("30.5"));
  EXPECT_THAT(text, HasSubstr("times 4.0"));
  EXPECT_THAT(text, HasSubstr("1000.0")) << "0.25 ms of the host times 4";
  EXPECT_THAT(text, HasSubstr("2000.0"));
}

TEST(CellJson, HasTheDocumentedShape) {
  const auto json = cell_json(counted_run(), {4, 2000});
  EXPECT_EQ(json["ppu_factor"], 4);
  ASSERT_EQ(json["frames"].size(), 5U);
  const auto& first = json["frames"][0];
  EXPECT_EQ(first["kind"], "initial");
  EXPECT_EQ(first["spes"][1]["sort_us"], 50);
  EXPECT_EQ(first["spes"][1]["total_us"], 50.5);
  EXPECT_EQ(first["spu_us"], 50.5);
  EXPECT_EQ(first["spu_start_us"], 2000);
  EXPECT_EQ(first["ppu_us"], 1000);
  EXPECT_EQ(json["frames"][4]["spu_start_us"], 0) << "frame 1 started no threads";
}

}  // namespace
}  // namespace cellsweep::report
