/// @file
/// The Cell engines on recorded scenes: the pairs that all-against-all finds, by count and hash.
#include <gtest/gtest.h>

#include <map>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "cellsweep/world/recording.h"
#include "engines/cell/cell_world.h"
#include "project_file.h"

namespace cellsweep::cell {
namespace {

struct Known {
  std::size_t pairs;
  std::string hash;
};

struct Recorded {
  std::string name;
  std::size_t updates;
  std::map<std::size_t, Known> frames;  // by number
};

void PrintTo(const Recorded& recorded, std::ostream* out) {
  *out << recorded.name;
}

const std::vector<Recorded> kRecordings = {
    {"pile",
     30,
     {{0, {5577, "875cb2208a071dd3"}}, {15, {4914, "add61a14b776a039"}}, {30, {3901, "c05c583740ead6b9"}}}},
    {"towers",
     5,
     {{0, {1059, "1bd83799cf2eaf2b"}},
      {1, {1146, "d5b11c5abf176677"}},
      {2, {1344, "72b1389cea3216e2"}},
      {3, {1665, "df40eae70b24e494"}},
      {4, {2119, "c62b8fc54f70b441"}},
      {5, {2369, "d3d6e065474af82e"}}}}};

struct Way {
  std::string name;
  SpeOptions spes;
};

void PrintTo(const Way& way, std::ostream* out) {
  *out << way.name;
}

const std::vector<Way> kWays = {
    {"host", {}},
    {"isa", {.spe_engine = SpeEngine::isa}},
    {"isa_late", {.spe_engine = SpeEngine::isa, .dma = DmaMode::late, .dma_seed = 5}}};

#if defined(CELLSWEEP_SANITIZED_TESTS)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// Instruction by instruction under a sanitizer: what is left has every engine and late transfers.
bool takes_minutes(const Way& way, const Recorded& recorded) {
  return kSanitized && (way.name == "isa" || (way.name == "isa_late" && recorded.name == "pile"));
}

using RecordingOfEngine = testing::TestWithParam<std::tuple<NamedEngine, Way, Recorded>>;

TEST_P(RecordingOfEngine, GivesTheKnownPairs) {
  const auto& [named, way, recorded] = GetParam();
  if (takes_minutes(way, recorded)) GTEST_SKIP() << "for the build without sanitizers";
  auto engine = named.make(way.spes);
  if (way.spes.spe_engine == SpeEngine::isa && !engine) GTEST_SKIP() << engine.status().message;
  ASSERT_TRUE(engine.ok()) << engine.status().message;
  const std::string path = project_file("bench/scenes/bullet-" + recorded.name + "-1024.aabbs");
  auto recording = read_recording(path);
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  const auto source = make_recording_frames(std::move(*recording));
  ASSERT_TRUE(insert_all(*engine, *source).ok());
  for (std::size_t frame = 0; frame <= recorded.updates; ++frame) {
    if (frame > 0) {
      ASSERT_TRUE(source->advance());
      ASSERT_TRUE(move_changed(*engine, *source).ok());
    }
    ASSERT_TRUE(engine->update().ok());
    const auto known = recorded.frames.find(frame);
    if (known == recorded.frames.end()) continue;
    EXPECT_EQ(engine->pairs().size(), known->second.pairs) << "frame " << frame;
    EXPECT_EQ(hash_text(pair_set_hash(engine->pairs())), known->second.hash) << "frame " << frame;
  }
}

INSTANTIATE_TEST_SUITE_P(Cell, RecordingOfEngine,
                         testing::Combine(testing::ValuesIn(kEngines), testing::ValuesIn(kWays),
                                          testing::ValuesIn(kRecordings)),
                         [](const auto& test) {
                           return std::get<0>(test.param).name + "_" + std::get<1>(test.param).name + "_" +
                                  std::get<2>(test.param).name;
                         });

}  // namespace
}  // namespace cellsweep::cell
