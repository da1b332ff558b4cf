/// @file
/// Engine `stream` without its handle: what it keeps when bodies or pairs have gone, or an update was
/// refused.
#include <gtest/gtest.h>
#include <malloc.h>

#include <memory>
#include <vector>

#include "base/memory/starved.h"
#include "base/threads/numbers_of_workers.h"
#include "base/threads/thread_pool.h"
#include "base/tuning.h"
#include "broadphase/bodies/bodies.h"
#include "engines/stream/stream.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

/// An engine, and bodies to tell it of.
class EngineMemory : public testing::TestWithParam<unsigned> {
 protected:
  void insert(const std::vector<Aabb>& boxes) {
    const Capacity any_number = {kSlotMask, "", ""};
    ASSERT_TRUE(bodies_.insert(*crew_, ids_below(boxes.size()), boxes, {}, "stream", any_number).ok());
    update();
  }
  void move(const std::vector<Aabb>& boxes, std::size_t count) {
    ASSERT_TRUE(bodies_.move(*crew_, ids_below(count), std::span(boxes).first(count)).ok());
    update();
  }
  void remove_all() {
    ASSERT_TRUE(bodies_.remove(ids_below(bodies_.size())).ok());
    update();
  }

  /// Takes the changes in and remembers what was found.
  void update() {
    statistics_.bytes = 0;
    const auto found = engine_.update(bodies_.begin_update(), statistics_);
    ASSERT_TRUE(found.ok()) << found.status().message;
    ended_ = found->ended.size();
    began_ = found->began.size();
    for (const auto part : found->more_began) began_ += part.size();
    bodies_.commit();
    engine_.count(statistics_);
  }

  std::shared_ptr<Crew> crew_ =
      std::make_shared<Crew>(std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given);
  Stream engine_{{crew_, 0, find_kernels(VectorIsa::best)}};
  Bodies bodies_;
  Statistics statistics_;
  std::size_t began_ = 0;
  std::size_t ended_ = 0;
};

TEST_P(EngineMemory, GoesBackWithTheLastBodyAndEveryPairEnds) {
  std::vector<Aabb> boxes = uniform_boxes(40'000 / kScale, 1);
  insert(boxes);
  const std::size_t pairs = began_;
  // All ways to look at changes leave lists behind.
  for (const float step : {0.01F, 0.01F, 3.0F, 3.0F}) {
    shake(boxes, step, 2);
    move(boxes, boxes.size());
    move(uniform_boxes(boxes.size(), 3), boxes.size() / 100);
    move(boxes, boxes.size() / 100);
  }
  for (int time = 0; time < 2; ++time) {
    remove_all();
    insert({boxes[0], boxes[0]});
    EXPECT_EQ(began_, 1U);
    EXPECT_EQ(ended_, 0U);
  }
  remove_all();
  EXPECT_EQ(ended_, 1U);
  EXPECT_GT(pairs, 10'000U / kScale);
  EXPECT_LE(statistics_.bytes, 450'000U + 50'000U * GetParam()) << "a little is kept, whatever the world";
}

/// Boxes that overlap nobody, in rows.
std::vector<Aabb> rows_of(std::size_t count) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = 2.0F * static_cast<float>(i % 100);
    const float y = 2.0F * static_cast<float>(i / 100);
    boxes.push_back({{x, y, 0}, {x + 1, y + 1, 1}});
  }
  return boxes;
}

constexpr std::size_t kCrowd = kScale == 1 ? 4000 : 2100;

// Fat boxes make lists that a world without them does not have.
TEST_P(EngineMemory, GoesBackOneUpdateAfterThatInWhichManyPairsEnded) {
  std::vector<Aabb> boxes = rows_of(kCrowd);
  insert(boxes);
  for (int frame = 0; frame < 4; ++frame) {
    shake(boxes, 0.01F, 1);
    move(boxes, kCrowd);
  }
  const std::uint64_t before = statistics_.bytes;
  move(std::vector<Aabb>(kCrowd, boxes[0]), kCrowd);
  ASSERT_EQ(began_, kCrowd * (kCrowd - 1) / 2);
  ASSERT_GT(statistics_.bytes, 20 * before);
  move(boxes, kCrowd);
  ASSERT_EQ(ended_, kCrowd * (kCrowd - 1) / 2);
  boxes[0].max[2] += 0.001F;
  move(boxes, 1);
  EXPECT_LE(statistics_.bytes, 2 * before);
  // What follows is not spoilt by it.
  boxes[1] = boxes[0];
  move(boxes, 2);
  EXPECT_EQ(began_, 1U);
  shake(boxes, 0.01F, 1);
  move(boxes, kCrowd);
  EXPECT_EQ(began_ + ended_, 0U);
  remove_all();
  EXPECT_EQ(ended_, 1U);
}

// Each in an update that looks at it alone and does not sum up what is held.
TEST_P(EngineMemory, GoesBackWhereBodiesWithManyPairsGoOneByOne) {
  constexpr BodyId kLarge = 1200;
  constexpr BodyId kSmall = 200;
  std::vector<Aabb> boxes(kLarge, Aabb{{-1, -1, -1}, {300, 300, 2}});
  for (const Aabb& box : rows_of(kSmall)) boxes.push_back(box);
  insert(boxes);
  std::size_t pairs = began_;
  ASSERT_EQ(pairs, kLarge * kSmall + kLarge * (kLarge - 1) / 2);
  const auto updates_of_all = [&] { return statistics_.counters[0].value; };
  const std::uint64_t made = updates_of_all();
  for (BodyId body = 0; body < kLarge; ++body) {
    ASSERT_TRUE(bodies_.remove({{body}}).ok());
    update();
    pairs -= ended_;
  }
  EXPECT_EQ(pairs, 0U);
  EXPECT_EQ(updates_of_all(), made);
  update();
  EXPECT_LE(statistics_.bytes, tuning::kFewBytes * (2 + GetParam()) + tuning::kBytesOfBody * kSmall);
}

// Two sets of cells and what makes them are held while all bodies move. A world at rest needs one; it is not
// given back between two steps of a world that is updated more often than it moves, nor time and again where
// few bodies move.
TEST_P(EngineMemory, GoesBackWhenAWorldHasComeToRest) {
  constexpr std::size_t kBodies = 20'000;  // sanitized, too: of a small world nothing would go back
  constexpr std::uint32_t kQuiet = tuning::kQuietToGiveBack;
  std::vector<Aabb> boxes = uniform_boxes(kBodies, 1);
  const auto rest = [&](std::uint32_t updates) {
    for (std::uint32_t i = 0; i < updates; ++i) update();
    return statistics_.bytes;
  };
  insert(boxes);
  for (int frame = 0; frame < 30; ++frame) {
    shake(boxes, 0.02F, 1);
    move(boxes, kBodies);
    rest(1);
  }
  const std::uint64_t moving = statistics_.bytes;
  EXPECT_EQ(rest(kQuiet - 1), moving);
  const std::uint64_t resting = rest(1);
  EXPECT_LE(2 * resting, moving);
  // What follows is exact.
  const std::vector<Aabb> other = uniform_boxes(kBodies, 2);
  for (const std::size_t movers : {std::size_t{1}, kBodies / 50, kBodies}) {
    move(other, movers);
    const std::size_t began = began_;
    const std::size_t ended = ended_;
    const std::uint64_t moved = statistics_.bytes;
    const std::uint64_t rested = rest(kQuiet + 1);
    EXPECT_EQ(rest(kQuiet + 1), rested) << movers;
    EXPECT_EQ(moved > rested, movers > 1) << movers;
    move(boxes, movers);
    EXPECT_EQ(began_, ended) << movers;
    EXPECT_EQ(ended_, began) << movers;
    // One mover neither keeps it nor gives anything back a second time.
    for (std::uint32_t i = 0; i < kQuiet; ++i) move(i % 2 != 0 ? boxes : other, 1);
    move(boxes, 1);
    EXPECT_LE(statistics_.bytes, resting + resting / 8) << movers;
  }
}

// To give some back takes some, where a list moves to a smaller place.
TEST_P(EngineMemory, GoesBackLaterWhereThereIsNoneLeft) {
  constexpr std::size_t kBodies = 20'000;
  constexpr std::uint32_t kQuiet = tuning::kQuietToGiveBack;
  const std::vector<Aabb> boxes = uniform_boxes(kBodies, 1);
  std::vector<Aabb> larger = boxes;
  for (Aabb& box : larger) box.max[0] += 7;
  insert(larger);
  const std::size_t pairs = began_;
  move(uniform_boxes(kBodies, 2), kBodies);
  move(boxes, kBodies);  // whose pairs are in the place of the first ones
  ASSERT_GT(pairs, 4 * began_);
  for (std::uint32_t i = 0; i < kQuiet; ++i) update();
  EXPECT_FALSE(fails_at(1, [&] { update(); }));
  const std::uint64_t waiting = statistics_.bytes;
  for (std::uint32_t i = 0; i <= kQuiet; ++i) update();
  EXPECT_LT(statistics_.bytes, waiting);
  move(larger, kBodies);
  EXPECT_EQ(ended_, 0U);
  remove_all();
  EXPECT_EQ(ended_, pairs);
}

TEST_P(EngineMemory, GoesBackInTheUpdateThatIsRefused) {
  const std::size_t most = kCrowd * (kCrowd - 1) / 2 - 1;
  Stream engine({crew_, most, find_kernels(VectorIsa::best)});
  Bodies bodies;
  const Capacity any_number = {kSlotMask, "", ""};
  ASSERT_TRUE(bodies.insert(*crew_, ids_below(kCrowd), rows_of(kCrowd), {}, "stream", any_number).ok());
  ASSERT_TRUE(engine.update(bodies.begin_update(), statistics_).ok());
  bodies.commit();
  ASSERT_TRUE(
      bodies.move(*crew_, ids_below(kCrowd), std::vector<Aabb>(kCrowd, Aabb{{0, 0, 0}, {1, 1, 1}})).ok());
  const BodyChanges heap = bodies.begin_update();
  const auto in_use = [] { return mallinfo2().uordblks + mallinfo2().hblkhd; };
  const std::size_t before = in_use();
  const auto found = engine.update(heap, statistics_);
  ASSERT_EQ(found.status().code, StatusCode::capacity);
  EXPECT_LE(in_use(), before + (std::size_t{1} << 20) * GetParam())
      << "it found " << most * 8 << " bytes of pairs";
}

INSTANTIATE_TEST_SUITE_P(Workers, EngineMemory, numbers_of_workers());

}  // namespace
}  // namespace cellsweep::stream
