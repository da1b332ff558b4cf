/// @file
/// Worlds that engine stream cuts into cells, and cells within cells: answers with each set of kernels, any
/// threads, at rest and while bodies move, are the reference's.
#include <cmath>
#include <numeric>
#include <optional>

#include "base/text.h"
#include "contract/box_kinds.h"
#include "contract/effort.h"
#include "queries/random_questions.h"

namespace cellsweep::queries {
namespace {

using contract::Random;

struct WorldKind {
  std::string name;
  std::vector<Aabb> (*make)(Random& random, std::size_t count);
};

Aabb cube(const Point& at, float edge) {
  return {at, {at[0] + edge, at[1] + edge, at[2] + edge}};
}

std::vector<Aabb> make_uniform(Random& random, std::size_t count) {
  const float side = 2 * std::cbrt(static_cast<float>(count));
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Point at = {random.between(0, side), random.between(0, side), random.between(0, side)};
    boxes.push_back(cube(at, random.between(0.5F, 1.5F)));
  }
  return boxes;
}

// A heap in a corner of a wide world: cells within cells.
std::vector<Aabb> make_heap(Random& random, std::size_t count) {
  std::vector<Aabb> boxes = make_uniform(random, count / 2);
  while (boxes.size() < count) {
    const Point at = {random.between(7, 8), random.between(7, 8), random.between(7, 8)};
    boxes.push_back(cube(at, random.between(0.01F, 0.05F)));
  }
  return boxes;
}

// A level: a ground under everything, walls, and things that stand on it.
std::vector<Aabb> make_level(Random& random, std::size_t count) {
  const float side = 3 * std::sqrt(static_cast<float>(count));
  std::vector<Aabb> boxes = {{{-1e6F, -1, -1e6F}, {1e6F, 0, 1e6F}}};
  while (boxes.size() < count) {
    const Point at = {random.between(0, side), 0, random.between(0, side)};
    if (random.one_in(50)) {
      boxes.push_back({at, {at[0] + side / 10, 3, at[2] + 0.2F}});
    } else {
      boxes.push_back(cube(at, static_cast<float>(random.whole(1, 3)) / 2));
    }
  }
  return boxes;
}

// Whole numbers: faces, corners and edges touch everywhere.
std::vector<Aabb> make_lattice(Random& random, std::size_t count) {
  const int side = static_cast<int>(std::cbrt(static_cast<float>(count))) + 1;
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = [&] { return static_cast<float>(random.whole(0, side)); };
    boxes.push_back(cube({number(), number(), number()}, static_cast<float>(random.whole(0, 2))));
  }
  return boxes;
}

// Two grounds as high as each other, the first and the last body, with cubes on them, level with them, and
// below.
std::vector<Aabb> make_grounds(Random& random, std::size_t count) {
  const float side = 2 * std::sqrt(static_cast<float>(count));
  const Aabb ground = {{-1e6F, -1, -1e6F}, {1e6F, 0, 1e6F}};
  std::vector<Aabb> boxes = {ground};
  while (boxes.size() + 1 < count) {
    const float bottom = static_cast<float>(random.whole(-3, 1));
    boxes.push_back(cube({random.between(0, side), bottom, random.between(0, side)}, 1));
  }
  boxes.push_back(ground);
  return boxes;
}

const WorldKind kKinds[] = {
    {"uniform", make_uniform}, {"heap", make_heap}, {"level", make_level}, {"lattice", make_lattice}};

struct Setting {
  VectorIsa isa;
  unsigned threads;
};

class WorldsOfStream : public testing::TestWithParam<WorldKind> {};

// A world that takes a step now and then, whose bodies get other filters and come and go.
class MovingWorld {
 public:
  MovingWorld(const WorldKind& kind, std::size_t count, const Setting& setting, std::uint64_t seed)
      : random_(seed),
        broadphase_(
            std::move(*make_broadphase(StreamOptions{.threads = setting.threads, .isa = setting.isa}))) {
    const std::vector<Aabb> boxes = kind.make(random_, count);
    std::vector<BodyId> ids(count);
    std::iota(ids.begin(), ids.end(), BodyId{7});
    EXPECT_TRUE(broadphase_.insert(ids, boxes).ok());
    for (std::size_t i = 0; i < count; ++i) truth_.boxes[ids[i]] = boxes[i];
    EXPECT_TRUE(broadphase_.update().ok());
  }

  const Reference& truth() const { return truth_; }
  Queries queries() const { return broadphase_.queries(); }

  void step(float share, float length) {
    for (auto& [body, box] : truth_.boxes) {
      if (random_.unit() >= share) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float way = random_.between(-length, length);
        box.min[axis] += way;
        box.max[axis] = std::max(box.max[axis] + way, box.min[axis]);
      }
      EXPECT_TRUE(broadphase_.move(body, box).ok());
    }
    filter_some();
    EXPECT_TRUE(broadphase_.update().ok());
  }

 private:
  void filter_some() {
    for (const auto& [body, box] : truth_.boxes) {
      if (!random_.one_in(40)) continue;
      const BodyFilter filter{.category = static_cast<std::uint32_t>(random_.below(8)),
                              .mask = 7,
                              .is_static = random_.one_in(4)};
      EXPECT_TRUE(broadphase_.set_filter(body, filter).ok());
      truth_.filters[body] = filter;
    }
  }

  Random random_;
  Broadphase broadphase_;
  Reference truth_;
};

TEST_P(WorldsOfStream, AnswersAreTheReferencesWithEachSetting) {
  constexpr std::size_t kBodies = contract::effort(3000, 2100, 2100);
  const int questions = contract::repeated(10, contract::effort(3, 1, 1));
  for (const Setting setting : {Setting{VectorIsa::portable, 1}, Setting{VectorIsa::sse41, 2},
                                Setting{VectorIsa::avx2, 3}, Setting{VectorIsa::best, 1}}) {
    if (!make_broadphase(StreamOptions{.isa = setting.isa}).ok()) continue;
    MovingWorld world(GetParam(), kBodies, setting, 1);
    for (const float share : {0.0F, 1.0F, 0.02F, 0.4F}) {
      world.step(share, 0.05F);
      if (share > 0.1F) world.queries().prepare();
      for (int i = 0; i < questions; ++i) {
        // In the order of cells, which has nothing to do with the kernels, and as they are.
        const std::size_t batch = i == 0 && share == 0 && setting.isa == VectorIsa::best ? 260 : 2;
        ASSERT_TRUE(answers_are_right(world.queries(), world.truth(), static_cast<std::uint64_t>(i), batch))
            << GetParam().name << ", kernels " << static_cast<int>(setting.isa) << ", share " << share;
      }
    }
  }
}

// More bodies than the topmost grid has cells for.
TEST_P(WorldsOfStream, AnswersAreTheReferencesInCellsWithinCells) {
  constexpr std::size_t kBodies = contract::effort(100000, 20000, 20000);
  MovingWorld world(GetParam(), kBodies, {VectorIsa::best, 2}, 2);
  for (int step = 0; step < 3; ++step) {
    if (step == 1) world.queries().prepare();
    ASSERT_TRUE(answers_are_right(world.queries(), world.truth(), static_cast<std::uint64_t>(step)))
        << GetParam().name;
    if (step == 1) world.step(1, 0.01F);
  }
}

std::optional<Touch> first_of(const std::vector<Touch>& touches) {
  return touches.empty() ? std::nullopt : std::optional(touches.front());
}

// Whoever is first, and at the same time whose number is less: a ground is reached behind what stands on it,
// and as soon as what is level with it.
TEST(WorldsWithAGround, WhatIsOnItIsTouchedFirst) {
  for (const VectorIsa isa : {VectorIsa::portable, VectorIsa::avx2, VectorIsa::best}) {
    if (!make_broadphase(StreamOptions{.isa = isa}).ok()) continue;
    const MovingWorld world({"grounds", make_grounds}, 800, {isa, 1}, 3);
    world.queries().prepare();
    Random random(4);
    for (int i = 0; i < contract::effort(2000, 1000, 500); ++i) {
      const Point from = {random.between(-5, 60), random.between(-4, 6), random.between(-5, 60)};
      Path path = Ray{from, {0, random.one_in(5) ? 1.0 : -1.0, 0}};
      if (random.one_in(2)) path.direction[0] = random.between(-1, 1);
      if (random.one_in(2)) path.direction[2] = random.between(-1, 1);
      if (random.one_in(3)) path.end = random.between(0, 8);
      if (random.one_in(4)) path.box.max[1] += 0.5F;
      const auto expected = first_of(world.truth().touches(path));
      ASSERT_EQ(*world.queries().first_touch(path), expected) << i;
      ASSERT_EQ(*world.queries().any_touch(path), expected.has_value()) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, WorldsOfStream, testing::ValuesIn(kKinds),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace cellsweep::queries
