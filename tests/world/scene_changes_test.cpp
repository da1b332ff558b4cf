#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "cellsweep/world/scene.h"
#include "scene_probe.h"

namespace cellsweep {
namespace {

using test::frames_of;

std::vector<BodyId> copy(std::span<const BodyId> ids) {
  return {ids.begin(), ids.end()};
}

std::vector<BodyId> without(const std::vector<BodyId>& all, const std::vector<BodyId>& some) {
  std::vector<BodyId> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

bool is_valid(const Aabb& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(box.min[axis]) || !std::isfinite(box.max[axis])) return false;
    if (box.min[axis] > box.max[axis]) return false;
  }
  return true;
}

/// A frame as it was.
struct Snapshot {
  std::vector<BodyId> bodies;
  std::vector<Aabb> boxes;

  explicit Snapshot(const FrameSource& source)
      : bodies(copy(source.bodies())), boxes(source.boxes().begin(), source.boxes().end()) {}
};

void expect_valid_boxes(const FrameSource& source) {
  for (const BodyId id : source.bodies()) ASSERT_TRUE(is_valid(source.boxes()[id])) << "body " << id;
}

void expect_the_changes_since(const Snapshot& before, const FrameSource& source) {
  const Snapshot now(source);
  ASSERT_EQ(now.boxes.size(), before.boxes.size());
  ASSERT_EQ(copy(source.inserted()), without(now.bodies, before.bodies));
  ASSERT_EQ(copy(source.removed()), without(before.bodies, now.bodies));
  std::vector<BodyId> changed;
  for (const BodyId id : without(now.bodies, copy(source.inserted()))) {
    if (now.boxes[id] != before.boxes[id]) changed.push_back(id);
  }
  ASSERT_EQ(copy(source.moved()), changed);
}

class EveryScene : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryScene, HasValidBoxesAndNamesExactlyWhatChangedForAnyNumberOfBodies) {
  for (const std::size_t bodies : {0, 1, 2, 13, 1'000, 20'000}) {
    const auto source = frames_of({.scene = GetParam(), .bodies = bodies});
    EXPECT_EQ(source->boxes().size(), bodies);
    EXPECT_EQ(source->bodies().size(), bodies);
    EXPECT_TRUE(source->moved().empty() && source->inserted().empty() && source->removed().empty());
    expect_valid_boxes(*source);
    for (int frame = 0; frame < (bodies > 1'000 ? 6 : 60); ++frame) {
      const Snapshot before(*source);
      ASSERT_TRUE(source->advance());
      expect_valid_boxes(*source);
      expect_the_changes_since(before, *source);
      ASSERT_FALSE(HasFatalFailure()) << bodies << " bodies, frame " << frame;
    }
  }
}

TEST_P(EveryScene, OnlySaysThatBodiesComeAndGoWhenTheyDo) {
  const auto source = frames_of({.scene = GetParam(), .bodies = 1'000});
  bool any = false;
  for (int frame = 0; frame < 40; ++frame) {
    ASSERT_TRUE(source->advance());
    any = any || !source->inserted().empty() || !source->removed().empty();
  }
  EXPECT_EQ(source->bodies_come_and_go(), any);
}

TEST_P(EveryScene, StandsStillWithoutSpeed) {
  const auto source = frames_of({.scene = GetParam(), .bodies = 200, .speed = 0});
  for (int frame = 0; frame < 20; ++frame) {
    ASSERT_TRUE(source->advance());
    EXPECT_TRUE(source->moved().empty());
  }
}

// But for the plane of the pile, which is outside of the room of its bodies.
TEST_P(EveryScene, KeepsItsBodiesWithinItsBoundsButForTheWayOfOneFrame) {
  const SceneSettings settings{.scene = GetParam(), .bodies = 500};
  const Aabb bounds = *scene_bounds(settings);
  const auto source = frames_of(settings);
  const BodyId first = GetParam() == "pile" ? 1 : 0;
  for (int frame = 0; frame < 300; ++frame) {
    for (const BodyId id : source->bodies().subspan(first)) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_GE(source->boxes()[id].min[axis], bounds.min[axis] - 2) << "body " << id << " frame " << frame;
        ASSERT_LE(source->boxes()[id].max[axis], bounds.max[axis] + 2) << "body " << id << " frame " << frame;
      }
    }
    ASSERT_TRUE(source->advance());
  }
}

TEST_P(EveryScene, HasItsGiantInTheSlotThatWasAskedForForGood) {
  for (const auto& [slot, id] : {std::pair{GiantSlot::first, BodyId{0}}, std::pair{GiantSlot::middle, 50U},
                                 std::pair{GiantSlot::last, 99U}}) {
    const SceneSettings settings{.scene = GetParam(), .bodies = 100, .giant = slot};
    const Aabb bounds = *scene_bounds(settings);
    const auto source = frames_of(settings);
    const Aabb giant = source->boxes()[id];
    EXPECT_GE(giant.max[0] - giant.min[0], 1.9F * (bounds.max[0] - bounds.min[0]));
    EXPECT_GE(giant.max[2] - giant.min[2], 1.9F * (bounds.max[2] - bounds.min[2]));
    for (int frame = 0; frame < 40; ++frame) {
      ASSERT_TRUE(source->advance());
      EXPECT_EQ(source->boxes()[id], giant);
      EXPECT_TRUE(std::binary_search(source->bodies().begin(), source->bodies().end(), id));
    }
  }
}

TEST_P(EveryScene, MakesRoomForAGiantEvenWhenItIsAlone) {
  for (const GiantSlot slot : {GiantSlot::first, GiantSlot::middle, GiantSlot::last}) {
    EXPECT_EQ(frames_of({.scene = GetParam(), .bodies = 1, .giant = slot})->bodies().size(), 1U);
    EXPECT_EQ(frames_of({.scene = GetParam(), .bodies = 0, .giant = slot})->bodies().size(), 0U);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const SceneInfo& info : scene_table()) names.emplace_back(info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(OfTheTable, EveryScene, ::testing::ValuesIn(names()), [](const auto& test) {
  std::string name = test.param;
  std::erase(name, '-');
  return name;
});

}  // namespace
}  // namespace cellsweep
