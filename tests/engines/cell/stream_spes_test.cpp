/// @file
/// Engine `cell-stream`: the cells of engine `stream` compared on SPEs.
#include <gmock/gmock.h>

#include <cmath>

#include "engines/cell/cell_world.h"
#include "engines/oracle/brute_force.h"

namespace cellsweep::cell {
namespace {

using contract::Random;

#ifdef CELLSWEEP_SANITIZED_TESTS
constexpr std::size_t kBodies = 190;
#else
constexpr std::size_t kBodies = 1500;
#endif

/// What an SPE may be.
struct Way {
  const char* name;
  CellStreamOptions options;
};

void PrintTo(const Way& way, std::ostream* out) {
  *out << way.name;
}

const Way kWays[] = {{"Host", {}},
                     {"HostWithLateDmaAndOneSpu", {.spes = {.dma = DmaMode::late, .dma_seed = 3}, .spus = 1}},
                     {"HostOfFourThreads", {.stream = {.threads = 4}}},
                     {"Isa", {.spes = {.spe_engine = SpeEngine::isa}}}};

/// Unit cubes, about one overlap for each.
std::vector<Aabb> uniform_boxes(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const float world = 2 * std::cbrt(static_cast<float>(count));
  std::vector<Aabb> boxes(count);
  for (Aabb& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = random.between(0, world);
      box.max[axis] = box.min[axis] + 1;
    }
  }
  return boxes;
}

/// Every box a little further, in a direction of its own.
void shake(std::vector<Aabb>& boxes, std::uint64_t seed) {
  Random random(seed);
  for (Aabb& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float by = random.between(-0.4F, 0.4F);
      box.min[axis] += by;
      box.max[axis] += by;
    }
  }
}

Broadphase engine_with(const std::vector<Aabb>& boxes, const CellStreamOptions& options) {
  Broadphase engine = make(options);
  EXPECT_TRUE(engine.insert(ids_up_to(boxes.size()), boxes).ok());
  return engine;
}

class StreamOnSpes : public testing::TestWithParam<Way> {
 protected:
  void SetUp() override {
    if (!make_broadphase(GetParam().options)) GTEST_SKIP() << "this build has no such SPEs";
  }
};

TEST_P(StreamOnSpes, FindsThePairsOfEveryUpdate) {
  std::vector<Aabb> boxes = uniform_boxes(kBodies, 1);
  Broadphase engine = engine_with(boxes, GetParam().options);
  EXPECT_EQ(engine.name(), "cell-stream");
  for (std::uint64_t frame = 0; frame < 4; ++frame) {
    ASSERT_TRUE(engine.update().ok());
    EXPECT_EQ(pairs_of(engine), brute_force_pairs(boxes)) << "frame " << frame;
    shake(boxes, frame);
    ASSERT_TRUE(engine.move(ids_up_to(boxes.size()), boxes).ok());
  }
  EXPECT_GE(counter(engine, "dma gets"), 4 * 3U)
      << "in each update a job, a list of pieces and a block at least";
  EXPECT_GT(counter(engine, "dma bytes out"), 0U);
  EXPECT_EQ(counter(engine, "partial updates"), 0U);
}

TEST_P(StreamOnSpes, ComparesBlocksOfACellThatIsLargerThanOne) {
  // More pairs than an SPE may send at a time, too.
  std::vector<Aabb> boxes = uniform_boxes(500, 2);
  for (std::size_t i = 0; i < 400; ++i) boxes[i] = {{1, 1, 1}, {2, 2, 2}};
  for (std::size_t i = 400; i < 480; ++i) boxes[i] = {{2, 2, 2}, {2, 2, 2}};
  Broadphase engine = engine_with(boxes, GetParam().options);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(pairs_of(engine), brute_force_pairs(boxes));
}

TEST_P(StreamOnSpes, StopsAtACapOfPairs) {
  CellStreamOptions options = GetParam().options;
  options.stream.max_pairs = 100;
  Broadphase engine = engine_with(std::vector<Aabb>(300), options);
  EXPECT_EQ(engine.update().status().code, StatusCode::capacity);
  EXPECT_TRUE(engine.pairs().empty());
}

INSTANTIATE_TEST_SUITE_P(Ways, StreamOnSpes, testing::ValuesIn(kWays),
                         [](const auto& way) { return way.param.name; });

TEST(StreamOnSpesOf, RefusesWhatItCannotBe) {
  EXPECT_EQ(make_broadphase(CellStreamOptions{.spus = 17}).status().setting, "spus");
  EXPECT_EQ(make_broadphase(CellStreamOptions{.spes = {.local_store = 100}}).status().setting, "local_store");
  const Status status = make_broadphase(CellStreamOptions{.spes = {.local_store = 72 << 10}}).status();
  EXPECT_EQ(status.code, StatusCode::capacity) << status.message;
  EXPECT_EQ(status.setting, "local_store");
  EXPECT_THAT(status.message, testing::HasSubstr("blocks of boxes"));
}

TEST(StreamOnSpesOf, StaysInsideOfTheLocalStore) {
  Broadphase engine = engine_with(uniform_boxes(1000, 3), {});
  ASSERT_TRUE(engine.update().ok());
  const auto statistics = cell_statistics(engine);
  ASSERT_TRUE(statistics.has_value());
  EXPECT_GT(statistics->local_store_high_water, 10'000U) << "its program alone is larger";
  EXPECT_LE(statistics->local_store_high_water, 256U << 10);
}

}  // namespace
}  // namespace cellsweep::cell
