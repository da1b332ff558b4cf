/// @file
/// Engine `stream` with its cells compared on SPEs.
#include <gmock/gmock.h>

#include <array>

#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

/// What an SPE may be.
struct Way {
  const char* name;
  EngineOptions options;
};

const std::array kWays = {
    Way{"Host", {.on_spes = true}},
    Way{"HostWithLateDmaAndOneSpu", {.on_spes = true, .spus = 1, .dma = DmaMode::late, .dma_seed = 3}},
    Way{"Isa", {.on_spes = true, .spe_engine = SpeEngine::isa}}};

class StreamOnSpes : public testing::TestWithParam<Way> {
 protected:
  void SetUp() override {
    if (!make_engine("stream", GetParam().options)) GTEST_SKIP() << "this build has no such SPEs";
  }
};

TEST_P(StreamOnSpes, FindsThePairsOfEveryUpdate) {
  std::vector<Aabb> boxes = uniform_boxes(1500 / kScale, 1);
  const auto engine = engine_with(boxes, GetParam().options);
  for (std::uint64_t frame = 0; frame < 4; ++frame) {
    ASSERT_TRUE(engine->update().ok());
    EXPECT_TRUE(is_exact(*engine, boxes));
    shake(boxes, 0.4F, frame);
    move_every(*engine, boxes, 1);
  }
  EXPECT_GE(counter(*engine, "dma gets"), 4 * 3U)
      << "in each update a job, a list of pieces and a block at least";
  EXPECT_GT(counter(*engine, "dma bytes out"), 0U);
  EXPECT_EQ(counter(*engine, "partial updates"), 0U);
}

TEST_P(StreamOnSpes, ComparesBlocksOfACellThatIsLargerThanOne) {
  // More pairs than an SPE may send at a time, too.
  std::vector<Aabb> boxes = uniform_boxes(500, 2);
  for (std::size_t i = 0; i < 400; ++i) boxes[i] = {{1, 1, 1}, {2, 2, 2}};
  for (std::size_t i = 400; i < 480; ++i) boxes[i] = {{2, 2, 2}, {2, 2, 2}};
  const auto engine = engine_with(boxes, GetParam().options);
  ASSERT_TRUE(engine->update().ok());
  EXPECT_TRUE(is_exact(*engine, boxes));
}

TEST_P(StreamOnSpes, StopsAtACapOfPairs) {
  EngineOptions options = GetParam().options;
  options.max_pairs = 100;
  const auto engine = engine_with(std::vector<Aabb>(300), options);
  EXPECT_EQ(engine->update().status().code, StatusCode::capacity);
  EXPECT_TRUE(engine->pairs().empty());
}

INSTANTIATE_TEST_SUITE_P(Ways, StreamOnSpes, testing::ValuesIn(kWays),
                         [](const auto& way) { return way.param.name; });

TEST(StreamOnSpesOf, RefusesWhatItCannotBe) {
  if (!make_engine("stream", {.on_spes = true})) GTEST_SKIP() << "this build has no SPEs";
  EXPECT_EQ(make_engine("stream", {.on_spes = true, .spus = 17}).status().setting, "spus");
  const Status status = make_engine("stream", {.on_spes = true, .local_store_bytes = 72 << 10}).status();
  EXPECT_EQ(status.code, StatusCode::capacity) << status.message;
  EXPECT_EQ(status.setting, "local_store_bytes");
  EXPECT_THAT(status.message, testing::HasSubstr("blocks of boxes"));
}

TEST(StreamOnSpesOf, StaysInsideOfTheLocalStore) {
  auto engine = make_engine("stream", {.on_spes = true});
  if (!engine) GTEST_SKIP() << "this build has no SPEs";
  ASSERT_TRUE((*engine)->insert(ids_below(1000), uniform_boxes(1000, 3)).ok());
  ASSERT_TRUE((*engine)->update().ok());
  EXPECT_GT(counter(**engine, "local store high water"), 10'000U) << "its program alone is larger";
  EXPECT_LE(counter(**engine, "local store high water"), 256U << 10);
}

}  // namespace
}  // namespace cellsweep::stream
