/// @file
/// Engine `stream` as a whole: what it chooses and says, and worlds of some thousand bodies.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "contract/effort.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using testing::HasSubstr;

TEST(Stream, ChoosesByTheShareOfBodiesThatChanged) {
  std::vector<Aabb> boxes = uniform_boxes(3000, 1);
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "full updates"), 1U);
  shake(boxes, 0.1F, 2);
  move_every(engine, boxes, 20);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "partial updates"), 1U);
  shake(boxes, 0.1F, 3);
  move_every(engine, boxes, 1);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "full updates"), 2U);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "idle updates"), 1U);
  EXPECT_TRUE(is_exact(engine, boxes));
}

TEST(Stream, LooksAtNoCellWhileBodiesKeepTheirCourse) {
  std::vector<Aabb> boxes = uniform_boxes(4000, 8);  // too many to be swept in every update
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  for (int frame = 0; frame < 8; ++frame) {
    for (Aabb& box : boxes) {
      box.min[0] += 0.01F;
      box.max[0] += 0.01F;
    }
    boxes[0].min[0] -= 0.02F;
    boxes[0].max[0] -= 0.02F;
    move_every(engine, boxes, 1);
    ASSERT_TRUE(engine.update().ok());
    ASSERT_TRUE(is_exact(engine, boxes)) << "frame " << frame;
  }
  EXPECT_EQ(counter(engine, "full updates"), 2U);
  EXPECT_GE(counter(engine, "in-place updates"), 5U);
}

TEST(Stream, CountsItsWork) {
  const std::vector<Aabb> boxes = uniform_boxes(5000, 3);  // too many for a sweep: they have cells
  Broadphase engine = engine_with(boxes);
  EXPECT_EQ(engine.statistics().work.boxes_placed, 0U);
  ASSERT_TRUE(engine.update().ok());
  const Work first = engine.statistics().work;
  EXPECT_EQ(first.boxes_placed, boxes.size());
  EXPECT_GE(first.boxes_compared, engine.pairs().size());
  EXPECT_EQ(first.boxes_compared, counter(engine, "boxes compared"));
  ASSERT_TRUE(engine.update().ok());
  const Work idle = engine.statistics().work - first;
  EXPECT_EQ(idle.boxes_placed + idle.boxes_compared, 0U);
  ASSERT_TRUE(engine.move(7, boxes[8]).ok());
  ASSERT_TRUE(engine.update().ok());
  const Work one = engine.statistics().work - first;
  EXPECT_EQ(one.boxes_placed, 1U);
  EXPECT_LT(one.boxes_compared, first.boxes_compared / 10);
}

/// Of how many bodies in a thousand the cells are looked at in a frame, while all tremble about where they
/// rest.
double changed_of_trembling(float by, const StreamOptions& options) {
  constexpr std::uint64_t kFirst = 20, kFrames = 120;
  const std::vector<Aabb> rest = uniform_boxes(2000 / kScale, 6);
  Broadphase engine = engine_with(rest, options);
  EXPECT_TRUE(engine.update().ok());
  std::uint64_t before = 0;
  for (std::uint64_t frame = 0; frame < kFrames; ++frame) {
    std::vector<Aabb> boxes = rest;
    shake(boxes, by, frame);
    move_every(engine, boxes, 1);
    EXPECT_TRUE(engine.update().ok());
    EXPECT_TRUE(frame % 10 != 0 || is_exact(engine, boxes));
    if (frame == kFirst) before = counter(engine, "fat boxes put into cells");
  }
  const auto changed = static_cast<double>(counter(engine, "fat boxes put into cells") - before);
  return 1000 * changed / static_cast<double>(rest.size() * (kFrames - kFirst));
}

// Whether to find all pairs anew is decided by what that took, which the times of an emulator say nothing
// about.
TEST(Stream, LooksAtNoCellWhileBodiesTrembleWithinTheMargin) {
  if (contract::kEmulated) GTEST_SKIP() << "the times of an emulator";
  EXPECT_EQ(changed_of_trembling(0.02F, {.margin = 0.05F}), 0);
  EXPECT_EQ(changed_of_trembling(1e-4F, {.margin = 0.001F}), 0);
}

TEST(Stream, LooksAtFewCellsWhileBodiesTrembleThoughNobodySaidHowMuch) {
  for (const float by : {1e-5F, 1e-3F, 0.01F}) EXPECT_LT(changed_of_trembling(by, {}), 20) << by;
}

TEST(Stream, StaysExactThroughManyPartialUpdates) {
  std::vector<Aabb> boxes = uniform_boxes(4000 / kScale, 4);
  std::vector<Aabb> shown = boxes;
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  for (std::uint64_t frame = 0; frame < 30; ++frame) {
    shake(boxes, 0.5F, frame);
    move_every(engine, boxes, 15);
    for (std::size_t i = 0; i < boxes.size(); i += 15) shown[i] = boxes[i];
    ASSERT_TRUE(engine.update().ok());
  }
  EXPECT_GT(counter(engine, "partial updates"), 20U);
  EXPECT_TRUE(is_exact(engine, shown));
}

struct Isa {
  VectorIsa isa;
  std::uint64_t lanes;
};

void PrintTo(const Isa& isa, std::ostream* out) {
  *out << isa.lanes << " lanes";
}

class StreamOnIsa : public testing::TestWithParam<Isa> {};

TEST_P(StreamOnIsa, RunsTheKernelsThatItWasToldTo) {
  const StreamOptions options{.isa = GetParam().isa};
  if (const auto made = make_broadphase(options); !made) GTEST_SKIP() << made.status().message;
  std::vector<Aabb> boxes = uniform_boxes(3000 / kScale, 5);
  Broadphase engine = engine_with(boxes, options);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "vector lanes"), GetParam().lanes);
  EXPECT_TRUE(is_exact(engine, boxes));
  shake(boxes, 0.3F, 6);
  move_every(engine, boxes, 1);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_TRUE(is_exact(engine, boxes));
}

INSTANTIATE_TEST_SUITE_P(All, StreamOnIsa,
                         testing::Values(Isa{VectorIsa::portable, 4}, Isa{VectorIsa::sse41, 4},
                                         Isa{VectorIsa::avx2, 8}, Isa{VectorIsa::avx512, 16}),
                         [](const auto& test) {
                           return "Isa" + std::to_string(static_cast<int>(test.param.isa));
                         });

TEST(Stream, RefusesAnInstructionSetThatThereIsNot) {
  const auto made = make_broadphase(StreamOptions{.isa = static_cast<VectorIsa>(99)});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.status().code, StatusCode::bad_option);
  EXPECT_EQ(made.status().setting, "isa");
  EXPECT_THAT(made.status().message, HasSubstr("instruction set"));
}

TEST(Stream, StartsNoThreadForASmallWorldUnlessAsked) {
  const std::vector<Aabb> boxes = uniform_boxes(200, 7);
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "workers"), 1U);
  Broadphase asked = engine_with(boxes, {.threads = 3});
  ASSERT_TRUE(asked.update().ok());
  EXPECT_EQ(counter(asked, "workers"), 3U);
}

TEST(Stream, ABodyThatComesBackWithTheSameIdEndsItsPairsAndBeginsThem) {
  const std::vector<Aabb> boxes(20, Aabb{{0, 0, 0}, {1, 1, 1}});
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  ASSERT_TRUE(engine.remove(3).ok());
  ASSERT_TRUE(engine.insert(3, boxes[3]).ok());
  const auto changes = engine.update();
  EXPECT_EQ(changes->began.size(), 19U);
  EXPECT_TRUE(std::ranges::equal(changes->began, changes->ended));
  for (const Pair& pair : changes->began) EXPECT_TRUE(pair.a == 3 || pair.b == 3);
  EXPECT_EQ(engine.pairs().size(), 190U);
}

TEST(Stream, PairsOfARemovedBodyEndUnderItsIdThoughItsPlaceIsTaken) {
  const std::vector<Aabb> boxes(12, Aabb{{0, 0, 0}, {1, 1, 1}});
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  ASSERT_TRUE(engine.remove(5).ok());
  ASSERT_TRUE(engine.insert(500, Aabb{{0, 0, 0}, {1, 1, 1}}).ok());
  const auto changes = engine.update();
  ASSERT_EQ(changes->ended.size(), 11U);
  ASSERT_EQ(changes->began.size(), 11U);
  for (const Pair& pair : changes->ended) EXPECT_TRUE(pair.a == 5 || pair.b == 5);
  for (const Pair& pair : changes->began) EXPECT_EQ(pair.b, 500U);
}

}  // namespace
}  // namespace cellsweep::stream
