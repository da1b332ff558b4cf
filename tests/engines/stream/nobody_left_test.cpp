/// @file
/// Engine `stream` without its handle: what it keeps when the last body has gone.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "base/thread_pool.h"
#include "broadphase/bodies/bodies.h"
#include "engines/stream/stream.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

/// An engine, and bodies to tell it of.
class NobodyLeft : public testing::TestWithParam<unsigned> {
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
  }

  std::shared_ptr<Crew> crew_ =
      std::make_shared<Crew>(std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given);
  Stream engine_{{crew_, 0, find_kernels(VectorIsa::best)}};
  Bodies bodies_;
  Statistics statistics_;
  std::size_t began_ = 0;
  std::size_t ended_ = 0;
};

TEST_P(NobodyLeft, EveryPairEndsAndTheMemoryGoesBack) {
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

INSTANTIATE_TEST_SUITE_P(Workers, NobodyLeft, testing::Values(1U, 3U));

}  // namespace
}  // namespace cellsweep::stream
