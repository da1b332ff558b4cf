/// @file
/// Bodies that run out of memory, wherever that happens: nothing has changed, and the call succeeds again.
#include <gmock/gmock.h>

#include <algorithm>

#include "base/memory/starved.h"
#include "broadphase/bodies/shown.h"

namespace cellsweep {
namespace {

/// Bodies of which some wait: dense and scattered ones, new, moved, removed and replaced ones.
struct State {
  Bodies bodies;
  Crew crew{nullptr, 1, Crew::Choice::given};
};

std::unique_ptr<State> make_state() {
  auto state = std::make_unique<State>();
  Bodies& bodies = state->bodies;
  EXPECT_TRUE(insert(bodies, ids_from(0, 20), boxes_from(0, 20)).ok());
  EXPECT_TRUE(insert(bodies, {0xffffffff, 4'000'000}, boxes_from(50, 2)).ok());
  update(bodies);
  EXPECT_TRUE(bodies.remove(Ids{3}).ok());
  update(bodies);
  EXPECT_TRUE(insert(bodies, {30, 31}, boxes_from(100, 2)).ok());
  EXPECT_TRUE(bodies.move(state->crew, Ids{5, 30, 0xffffffff}, boxes_from(200, 3)).ok());
  EXPECT_TRUE(bodies.remove(Ids{4, 7}).ok());
  EXPECT_TRUE(insert(bodies, {4}, boxes_from(300, 1)).ok());
  return state;
}

/// Expects that a call, wherever it fails, changes nothing, and afterwards does what it should.
template <class Call, class IsDone>
void expect_kept(const Call& call, const IsDone& is_done, std::uint64_t places) {
  const Shown before = shown_by(make_state()->bodies);
  const auto on_bodies = [&](const std::unique_ptr<State>& state) { call(*state); };
  const auto is_kept = [&](const std::unique_ptr<State>& state) {
    EXPECT_EQ(shown_by(state->bodies), before);
  };
  const auto is_right = [&](const std::unique_ptr<State>& state) { is_done(shown_by(state->bodies)); };
  EXPECT_GE(starve(make_state, on_bodies, is_kept, is_right), places);
}

TEST(BodiesWithoutMemory, AreAsTheyWereBeforeAnInsert) {
  Ids ids = ids_from(1000, 5000);
  for (BodyId i = 0; i < 3000; ++i) ids.push_back(0xfffffff0U - 1000 * i);
  const std::vector<Aabb> boxes = boxes_from(500, ids.size());
  expect_kept([&](State& state) { ASSERT_TRUE(insert(state.bodies, ids, boxes).ok()); },
              [&](const Shown& shown) {
                EXPECT_EQ(shown.inserted.size(), ids.size() + 3);
                EXPECT_EQ(shown.ids.size(), ids.size() + 22);
              },
              5);
}

TEST(BodiesWithoutMemory, AreAsTheyWereBeforeAnAdd) {
  const std::vector<Aabb> boxes = boxes_from(500, 5000);
  Ids ids(boxes.size());
  expect_kept(
      [&](State& state) { ASSERT_TRUE(state.bodies.add(state.crew, boxes, ids, "test", kAnyNumber).ok()); },
      [&](const Shown& shown) {
        EXPECT_EQ(shown.inserted.size(), ids.size() + 3);
        for (const BodyId id : ids) ASSERT_TRUE(shown.ids.contains(id));
      },
      6);
}

TEST(BodiesWithoutMemory, AreAsTheyWereBeforeAMove) {
  const Ids ids = {0, 1, 2, 5, 6, 8, 9, 30, 4, 5};
  const std::vector<Aabb> boxes = boxes_from(500, ids.size());
  expect_kept([&](State& state) { ASSERT_TRUE(state.bodies.move(state.crew, ids, boxes).ok()); },
              [&](const Shown& shown) {
                EXPECT_EQ(shown.moved.size(), 8U);
                EXPECT_EQ(shown.boxes[5], bits(boxes[9]));
              },
              1);
}

TEST(BodiesWithoutMemory, AreAsTheyWereBeforeARemoval) {
  const Ids ids = {5, 0, 31, 0xffffffff, 4};
  expect_kept([&](State& state) { ASSERT_TRUE(state.bodies.remove(ids).ok()); },
              [&](const Shown& shown) {
                EXPECT_EQ(shown.bodies, 17U);
                for (const BodyId id : ids) EXPECT_FALSE(shown.ids.contains(id));
              },
              1);
}

TEST(BodiesWithoutMemory, AreListedForANewEngineAgain) {
  for (std::uint64_t n = 1;; ++n) {
    const auto state = make_state();
    Bodies& bodies = state->bodies;
    const Shown before = shown_by(bodies);
    bodies.begin_update();
    const bool failed = fails_at(n, [&] { bodies.all_as_new(); });
    if (failed) {
      bodies.undo();
      EXPECT_EQ(shown_by(bodies), before);
      bodies.begin_update();
    }
    EXPECT_EQ(bodies.all_as_new().inserted.size(), bodies.size());
    bodies.commit();
    if (failed) continue;
    EXPECT_EQ(n, 2U);
    break;
  }
}

TEST(BodiesWithoutMemory, UpdateThemselvesWithoutAny) {
  const auto state = make_state();
  EXPECT_FALSE(fails_at(1, [&] { update(state->bodies); }));
  EXPECT_FALSE(fails_at(1, [&] {
    state->bodies.begin_update();
    state->bodies.undo();
  }));
  Ids held;
  for (const auto& [id, slot] : shown_by(state->bodies).ids) held.push_back(id);
  ASSERT_TRUE(state->bodies.remove(held).ok());
  EXPECT_FALSE(fails_at(1, [&] { update(state->bodies); }));
  EXPECT_EQ(state->bodies.bytes(), 0U);
}

TEST(BodiesWithoutMemory, KeepTheirSlotsWhenThereIsNoneToNumberThemAnew) {
  const auto make = [] {
    auto state = std::make_unique<State>();
    EXPECT_TRUE(insert(state->bodies, ids_from(0, 4000), boxes_from(0, 4000)).ok());
    EXPECT_TRUE(insert(state->bodies, {0xffffffff}, boxes_from(9, 1)).ok());
    update(state->bodies);
    EXPECT_TRUE(state->bodies.remove(ids_from(100, 3900)).ok());
    update(state->bodies);
    return state;
  };
  const Shown before = shown_by(make()->bodies);
  const auto tidy = [](const std::unique_ptr<State>& state) { EXPECT_TRUE(state->bodies.tidy()); };
  const auto is_kept = [&](const std::unique_ptr<State>& state) {
    EXPECT_EQ(shown_by(state->bodies), before);
  };
  const auto is_done = [&](const std::unique_ptr<State>& state) {
    EXPECT_EQ(state->bodies.table().slot_count(), 101U);
    EXPECT_EQ(box_of(state->bodies, 99), bits(box_at(198)));
    EXPECT_EQ(box_of(state->bodies, 0xffffffff), bits(box_at(9)));
  };
  EXPECT_GE(starve(make, tidy, is_kept, is_done), 6U);
}

}  // namespace
}  // namespace cellsweep
