/// @file
/// Few bodies change among many: engine `stream` tells exactly what began and ended, and its work follows the
/// change.
#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <vector>

#include "base/tuning.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using contract::Random;

/// Bodies in a broadphase, and the truth about them.
class World {
 public:
  World(std::uint64_t seed, std::size_t bodies, const StreamOptions& options)
      : random_(seed), engine_(std::move(*make_broadphase(options))) {
    std::vector<BodyId> ids = ids_below(bodies);
    const std::vector<Aabb> boxes = uniform_boxes(bodies, seed);
    edge_ = 2 * std::cbrt(static_cast<float>(bodies));
    EXPECT_TRUE(engine_.insert(ids, boxes).ok());
    for (const BodyId id : ids) held_[id] = boxes[id];
    update();
  }

  Random& random() { return random_; }
  const Broadphase& engine() const { return engine_; }

  /// A step along, a leap, or a tremble; seldom a giant.
  void move_one() {
    const auto [id, old] = any();
    Aabb box = cube_in(random_, random_.one_in(40) ? edge_ / 2 : random_.between(0.2F, 2), edge_);
    if (random_.one_in(2)) {
      const float step = random_.one_in(2) ? 0.05F : 1e-5F;
      box = old;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float by = random_.between(-step, step);
        box.min[axis] += by;
        box.max[axis] += by;
      }
    }
    ASSERT_TRUE(engine_.move(id, box).ok());
    held_[id] = box;
  }
  void move_all() {
    std::vector<BodyId> ids;
    std::vector<Aabb> boxes;
    for (auto& [id, box] : held_) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float by = random_.between(-0.02F, 0.02F);
        box.min[axis] += by;
        box.max[axis] += by;
      }
      ids.push_back(id);
      boxes.push_back(box);
    }
    ASSERT_TRUE(engine_.move(ids, boxes).ok());
  }
  void remove_one() {
    const BodyId id = any().first;
    ASSERT_TRUE(engine_.remove(id).ok());
    held_.erase(id);
  }
  void insert_one() {
    const Aabb box = cube_in(random_, 1, edge_);
    const auto id = engine_.add(box);
    ASSERT_TRUE(id.ok());
    ASSERT_TRUE(held_.emplace(*id, box).second);
  }

  void update() {
    const auto changes = engine_.update();
    ASSERT_TRUE(changes.ok());
    const std::set<Pair> now = truth();
    // A removed body's id waits until its pairs have ended, so no pair is both old and new.
    std::vector<Pair> began;
    std::vector<Pair> ended;
    std::ranges::set_difference(now, pairs_, std::back_inserter(began));
    std::ranges::set_difference(pairs_, now, std::back_inserter(ended));
    EXPECT_TRUE(std::ranges::equal(changes->began, began));
    EXPECT_TRUE(std::ranges::equal(changes->ended, ended));
    pairs_ = now;
  }

  void expect_all_pairs() const { EXPECT_TRUE(std::ranges::equal(engine_.pairs(), pairs_)); }

 private:
  std::pair<BodyId, Aabb> any() {
    return *std::next(held_.begin(), static_cast<int>(random_.below(held_.size())));
  }

  std::set<Pair> truth() const {
    std::vector<BodyId> ids;
    std::vector<Aabb> boxes;
    for (const auto& [id, box] : held_) {
      ids.push_back(id);
      boxes.push_back(box);
    }
    std::set<Pair> pairs;
    for (const Pair& pair : pairs_among(boxes)) pairs.insert({ids[pair.a], ids[pair.b]});
    return pairs;
  }

  Random random_;
  Broadphase engine_;
  float edge_ = 0;
  std::map<BodyId, Aabb> held_;
  std::set<Pair> pairs_;
};

class FewMovers : public testing::TestWithParam<unsigned> {
 protected:
  static constexpr std::size_t kBodies = 1200 / kScale;
};

TEST_P(FewMovers, LeaveExactlyThePairsOfBruteForce) {
  World world(GetParam(), kBodies, {.threads = GetParam()});
  for (int frame = 0; frame < 400 && !HasFailure(); ++frame) {
    if (frame >= 150 && world.random().one_in(12)) world.move_all();
    for (int i = world.random().whole(0, world.random().one_in(4) ? 8 : 3); i > 0; --i) world.move_one();
    if (world.random().one_in(4)) world.remove_one();
    if (world.random().one_in(4)) world.insert_one();
    world.update();
    if (world.random().one_in(5)) world.expect_all_pairs();
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, FewMovers, testing::Values(1U, 2U));

/// Comparisons of two boxes that the last update made.
class CountedWork {
 public:
  explicit CountedWork(const Broadphase& engine) : engine_(engine) { of_update(); }
  std::uint64_t of_update() {
    const std::uint64_t now = counter(engine_, "boxes compared");
    return now - std::exchange(before_, now);
  }

 private:
  const Broadphase& engine_;
  std::uint64_t before_ = 0;
};

TEST(OneMover, CostsTheSameAmongFewAndAmongMany) {
  for (const std::size_t bodies : {4000, 16'000}) {
    std::vector<Aabb> boxes = uniform_boxes(bodies, 5);
    Broadphase engine = engine_with(boxes);
    ASSERT_TRUE(engine.update().ok());
    CountedWork work(engine);
    for (int frame = 0; frame < 20; ++frame) {
      Aabb& box = boxes[boxes.size() / 2];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.min[axis] += 0.3F;
        box.max[axis] += 0.3F;
      }
      ASSERT_TRUE(engine.move(static_cast<BodyId>(boxes.size() / 2), box).ok());
      ASSERT_TRUE(engine.update().ok());
      EXPECT_LT(work.of_update(), 4000U) << bodies << " bodies, frame " << frame;
    }
  }
}

// What waits is not brought up to date for them, and then again.
TEST(AFewMoreMovers, DoNotHaveAllCandidatesWalked) {
  constexpr std::size_t kBodies = 8000;
  std::vector<Aabb> boxes = uniform_boxes(kBodies, 5);
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  CountedWork work(engine);
  const auto work_of = [&](std::size_t movers) {
    for (std::size_t i = 0; i < movers; ++i) {
      Aabb& box = boxes[i * (kBodies / movers)];
      box.min[0] += 0.3F;
      box.max[0] += 0.3F;
      EXPECT_TRUE(engine.move(static_cast<BodyId>(i * (kBodies / movers)), box).ok());
    }
    EXPECT_TRUE(engine.update().ok());
    return work.of_update();
  };
  work_of(1);
  const std::uint64_t candidates = counter(engine, "candidates");
  const std::size_t a_few = candidates / tuning::kCandidatesOfQuery;
  for (int round = 0; round < 10; ++round) {
    EXPECT_LT(work_of(a_few - 4), candidates) << round;
    EXPECT_LT(work_of(a_few + 3), candidates) << round;
  }
  EXPECT_TRUE(is_exact(engine, boxes));
}

TEST(OneMover, TakesNoMemoryForTheOthers) {
  constexpr std::size_t kBodies = 20'000;
  const std::vector<Aabb> boxes = uniform_boxes(kBodies, 5);
  Broadphase engine = engine_with(boxes);
  ASSERT_TRUE(engine.update().ok());
  const std::size_t at_rest = engine.statistics().bytes;
  for (const BodyId id : {BodyId{7}, BodyId{kBodies - 1}, BodyId{10'000}}) {
    Aabb box = boxes[id];
    box.max[0] += 0.1F;
    ASSERT_TRUE(engine.move(id, box).ok());
    ASSERT_TRUE(engine.update().ok());
    EXPECT_LT(engine.statistics().bytes - at_rest, 4 * kBodies);
  }
}

// Nor does the list of all pairs have two places any more, of which one is made a part at a time while there
// are changes.
TEST(WorldThatCameToRest, TakesAtMost160BytesABody) {
  constexpr std::size_t kBodies = 10'000;
  std::vector<Aabb> boxes = uniform_boxes(kBodies, 5);
  for (Aabb& box : boxes) {
    for (float& max : box.max) max += 0.2F;
  }
  Broadphase engine = engine_with(boxes);
  for (std::uint64_t frame = 0; frame < 8; ++frame) {
    shake(boxes, 0.02F, frame);
    move_every(engine, boxes, 1);
    ASSERT_TRUE(engine.update().ok());
  }
  const std::size_t moving = engine.statistics().bytes;
  for (std::uint32_t quiet = 0; quiet < tuning::kQuietToGiveBack + 2; ++quiet)
    ASSERT_TRUE(engine.update().ok());
  EXPECT_LT(engine.statistics().bytes, moving / 2);
  EXPECT_LE(engine.statistics().bytes, 160 * kBodies);
  EXPECT_TRUE(std::ranges::equal(engine.pairs(), pairs_among(boxes)));
  shake(boxes, 0.02F, 8);
  move_every(engine, boxes, 1);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_TRUE(std::ranges::equal(engine.pairs(), pairs_among(boxes)));
}

}  // namespace
}  // namespace cellsweep::stream
