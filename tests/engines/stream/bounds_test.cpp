/// @file
/// Worlds that somebody made to be costly: what engine `stream` takes for them stays below a bound that is
/// linear in bodies and pairs. Work and bytes are counted, not timed.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <vector>

#include "base/tuning.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using contract::Random;

/// Enough for a grid to be far too fine, and few enough to ask brute force.
constexpr std::size_t kMany = 20'000 / kScale;
constexpr std::size_t kFew = 3000;

/// The stated bounds: docs/stream.md.
constexpr double kMostCopiesOfBody = 40;
constexpr double kMostBytesOfBody = 4096;
constexpr double kMostBytesOfPair = 192;
constexpr double kMostBytesAlways = 8 << 20;

/// Whether a body's box is one of the few that a grid is chosen on.
bool is_sampled(std::size_t body, std::size_t bodies) {
  const std::size_t wanted = std::min(bodies, std::min(tuning::kSample, 24 + bodies / 64));
  const std::size_t next = (body * wanted + bodies - 1) / bodies;
  return next * bodies / wanted == body;
}

Aabb box_at(const std::array<float, 3>& at, const std::array<float, 3>& edges) {
  Aabb box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = at[axis];
    box.max[axis] = at[axis] + edges[axis];
  }
  return box;
}

Aabb dust(Random& random, float edge) {
  return cube_in(random, edge, 1);
}

/// A sheet of this edge, or a rod along an axis.
Aabb sheet(Random& random, float edge) {
  return box_at({random.unit() * (1 - edge), random.unit() * (1 - edge), random.unit()}, {edge, edge, 0});
}
Aabb rod(Random& random, std::size_t axis) {
  std::array<float, 3> at = {random.unit(), random.unit(), random.unit()};
  std::array<float, 3> edges = {0, 0, 0};
  at[axis] = 0;
  edges[axis] = 1;
  return box_at(at, edges);
}

/// One box of each world, of so many.
using MakeBox = std::function<Aabb(Random& random, std::size_t body, std::size_t bodies)>;

struct CostlyWorld {
  const char* name;
  MakeBox make;
  double most_tests;  ///< comparisons for each body and pair
};

void PrintTo(const CostlyWorld& world, std::ostream* out) {
  *out << world.name;
}

/// Sheets so many times as long as the dust in the sample, which has this edge.
MakeBox dust_where_sampled(float edge, float times) {
  return [=](Random& random, std::size_t body, std::size_t bodies) {
    return is_sampled(body, bodies) ? dust(random, edge) : sheet(random, std::min(1.0F, edge * times));
  };
}

const CostlyWorld kWorlds[] = {
    {"sheets_but_for_dust_where_boxes_are_sampled", dust_where_sampled(1e-3F, 1000), 64},
    {"sheets_a_little_longer_than_sampled_dust", dust_where_sampled(0.1F, 4), 64},
    {"sheets_just_short_of_large", dust_where_sampled(0.08F, 11.9F), 64},
    {"fine_sheets_just_short_of_large", dust_where_sampled(0.03F, 11.9F), 64},
    {"dust_but_for_sheets_where_boxes_are_sampled",
     [](Random& random, std::size_t body, std::size_t bodies) {
       return is_sampled(body, bodies) ? sheet(random, 1) : dust(random, 1e-4F);
     },
     64},
    {"dust_but_for_plates_in_three_directions_where_boxes_are_sampled",
     [](Random& random, std::size_t body, std::size_t bodies) {
       if (!is_sampled(body, bodies)) return dust(random, 1e-4F);
       std::array<float, 3> at = {0, 0, 0};
       std::array<float, 3> edges = {1, 1, 1};
       at[body % 3] = random.unit();
       edges[body % 3] = 0;
       return box_at(at, edges);
     },
     64},
    {"crowd_in_one_place_but_for_dust_where_boxes_are_sampled",
     [](Random& random, std::size_t body, std::size_t bodies) {
       if (is_sampled(body, bodies)) return dust(random, 1e-4F);
       return box_at({0.5F + 1e-4F * random.unit(), 0.5F + 1e-4F * random.unit(), 0.5F}, {0, 0, 0});
     },
     64},
    {"crowds_in_crowds",
     [](Random& random, std::size_t body, std::size_t) {
       const float scale = std::ldexp(1.0F, -static_cast<int>(body % 20));
       return box_at({scale * random.unit(), scale * random.unit(), scale * random.unit()}, {0, 0, 0});
     },
     64},
    {"rods_in_three_directions",
     [](Random& random, std::size_t body, std::size_t) { return rod(random, body % 3); }, 4000},
    {"rods_but_for_dust_where_boxes_are_sampled",
     [](Random& random, std::size_t body, std::size_t bodies) {
       return is_sampled(body, bodies) ? dust(random, 1e-5F) : rod(random, body % 3);
     },
     4000},
    {"dust_and_sheets_and_rods_of_all_sizes",
     [](Random& random, std::size_t body, std::size_t bodies) {
       const float edge = std::ldexp(1.0F, -random.whole(1, 12));
       if (is_sampled(body, bodies)) return dust(random, edge * edge);
       std::array<float, 3> edges = {edge, edge, edge};
       edges[body % 3] *= 1e-4F;
       if (body % 2 == 0) edges[(body + 1) % 3] *= 1e-4F;
       return box_at({random.unit(), random.unit(), random.unit()}, edges);
     },
     400},
    {"cubes_that_all_cross_the_middle_of_two_axes",
     [](Random&, std::size_t body, std::size_t bodies) {
       const float z = static_cast<float>(body) / static_cast<float>(bodies);
       return box_at({-0.5F, -0.5F, z}, {1, 1, 0});
     },
     64},
    {"boxes_that_are_all_equal",
     [](Random&, std::size_t body, std::size_t) {
       const auto heap = static_cast<float>(body / 200);
       return box_at({heap, 0, 0}, {0.5F, 0.5F, 0.5F});
     },
     64},
    {"boxes_in_boxes",
     [](Random&, std::size_t body, std::size_t) {
       const auto nest = static_cast<float>(body / 100);
       const float edge = std::ldexp(1.0F, -static_cast<int>(body % 100));
       return box_at({2 * nest, 0, 0}, {edge, edge, edge});
     },
     64},
    {"boxes_on_one_axis",
     [](Random& random, std::size_t body, std::size_t bodies) {
       return box_at({static_cast<float>(is_sampled(body, bodies)), 0, random.unit()}, {0, 1, 1e-6F});
     },
     64},
    {"boxes_from_end_to_end_of_the_numbers",
     [](Random& random, std::size_t body, std::size_t) {
       const float scale = std::ldexp(1.0F, random.whole(-120, 120));
       return box_at({scale * random.between(-1, 1), scale * random.between(-1, 1), scale},
                     {body % 2 == 0 ? 0 : scale * 1e-3F, 0, 0});
     },
     64},
};

std::vector<Aabb> boxes_of(const CostlyWorld& world, std::size_t count) {
  Random random(7);
  std::vector<Aabb> boxes;
  for (std::size_t body = 0; body < count; ++body) boxes.push_back(world.make(random, body, count));
  return boxes;
}

/// That an update took no more than it may, after one that left these comparisons.
void expect_bounded(const Broadphase& engine, std::size_t bodies, std::uint64_t tests_before,
                    double most_tests) {
  const auto count = static_cast<double>(bodies);
  const auto pairs = static_cast<double>(engine.pairs().size());
  const auto tests = static_cast<double>(counter(engine, "boxes compared") - tests_before);
  EXPECT_LE(static_cast<double>(counter(engine, "boxes in cells")), kMostCopiesOfBody * count);
  EXPECT_LE(tests, most_tests * (count + pairs));
  EXPECT_LE(static_cast<double>(engine.statistics().bytes),
            kMostBytesAlways + kMostBytesOfBody * count + kMostBytesOfPair * pairs);
}

class Bounds : public testing::TestWithParam<CostlyWorld> {
 protected:
  const CostlyWorld& world() const { return GetParam(); }
};

TEST_P(Bounds, HoldWhenAllIsNew) {
  for (const std::size_t count : {kMany, kFew}) {
    const std::vector<Aabb> boxes = boxes_of(world(), count);
    Broadphase engine = engine_with(boxes, {.threads = count == kFew ? 3U : 1U});
    ASSERT_TRUE(engine.update().ok());
    expect_bounded(engine, boxes.size(), 0, world().most_tests);
    EXPECT_TRUE(count != kFew || is_exact(engine, boxes));
  }
}

/// Dust, so many of whose bodies become bodies of this world in each of two updates.
void expect_bounded_changes(const CostlyWorld& world, std::size_t count, std::size_t every) {
  SCOPED_TRACE(testing::Message() << count << " bodies, one in " << every);
  const std::vector<Aabb> target = boxes_of(world, count);
  Random random(3);
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(dust(random, 1e-3F));
  Broadphase engine = engine_with(boxes, {.threads = count == kFew ? 3U : 1U});
  ASSERT_TRUE(engine.update().ok());
  shake(boxes, 1e-5F, 4);
  move_every(engine, boxes, 1);
  ASSERT_TRUE(engine.update().ok());
  for (std::size_t first = 0; first < 2; ++first) {
    std::vector<BodyId> ids;
    std::vector<Aabb> moved;
    for (std::size_t i = first; i < count; i += every) {
      boxes[i] = target[i];
      ids.push_back(static_cast<BodyId>(i));
      moved.push_back(target[i]);
    }
    const std::uint64_t tests = counter(engine, "boxes compared");
    ASSERT_TRUE(engine.move(ids, moved).ok());
    ASSERT_TRUE(engine.update().ok());
    // A change of cells that turns out to be too costly, and then everything anew.
    expect_bounded(engine, count, tests, world.most_tests + 1100);
  }
  EXPECT_TRUE(count != kFew || is_exact(engine, boxes));
}

TEST_P(Bounds, HoldWhenDustBecomesIt) {
  for (const std::size_t every : {2000, 30, 12, 2}) {
    for (const std::size_t count : {kMany, kFew}) expect_bounded_changes(world(), count, every);
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, Bounds, testing::ValuesIn(kWorlds),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace cellsweep::stream
