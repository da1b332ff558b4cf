/// @file
/// Engine `stream` on recorded scenes: the pairs that all-against-all finds, by count and hash.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cellsweep/engines.h"
#include "cellsweep/world/recording.h"
#include "report/run_engine.h"

namespace cellsweep::stream {
namespace {

void expect_frames(const std::string& name, const std::vector<report::FrameReport>& known) {
  auto recording = read_recording(CELLSWEEP_SOURCE_DIR "/bench/scenes/bullet-" + name + "-1024.aabbs");
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  const auto source = make_recording_frames(std::move(*recording));
  auto engine = make_engine("stream");
  report::RunSettings settings;
  settings.updates = known.back().frame;
  for (const report::FrameReport& frame : known) settings.report_frames.push_back(frame.frame);
  const auto run = report::run_engine(**engine, *source, settings);
  ASSERT_TRUE(run.ok()) << run.status().message;
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_EQ(run->frames[i].pairs, known[i].pairs) << "frame " << known[i].frame;
    EXPECT_EQ(run->frames[i].hash, known[i].hash) << "frame " << known[i].frame;
  }
}

TEST(StreamOnRecordings, GivesTheKnownPairsOfThePile) {
  expect_frames(
      "pile",
      {{0, 5577, 0x875cb2208a071dd3}, {15, 4914, 0xadd61a14b776a039}, {30, 3901, 0xc05c583740ead6b9}});
}

TEST(StreamOnRecordings, GivesTheKnownPairsOfTheTowers) {
  expect_frames(
      "towers",
      {{0, 1059, 0x1bd83799cf2eaf2b}, {3, 1665, 0xdf40eae70b24e494}, {5, 2369, 0xd3d6e065474af82e}});
}

}  // namespace
}  // namespace cellsweep::stream
