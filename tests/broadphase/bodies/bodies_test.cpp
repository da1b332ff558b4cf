/// @file
/// Bodies between updates and through them: what waits, what is told, and what comes back after a failure.
#include "broadphase/bodies/bodies.h"

#include <gmock/gmock.h>

#include <limits>

#include "broadphase/bodies/shown.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

class BodiesTest : public testing::Test {
 protected:
  /// Bodies 0 ... count - 1 that an update has seen, each at twice its number.
  void fill(std::size_t count) {
    ASSERT_TRUE(insert(bodies_, ids_from(0, count), boxes_from(0, count)).ok());
    update(bodies_);
  }
  Status move(const Ids& ids, const std::vector<Aabb>& boxes) { return bodies_.move(crew_, ids, boxes); }

  Crew crew_{nullptr, 1, Crew::Choice::given};
  Bodies bodies_;
};

TEST_F(BodiesTest, AreNoneAtFirst) {
  EXPECT_EQ(bodies_.size(), 0U);
  EXPECT_EQ(bodies_.bytes(), 0U);
  EXPECT_TRUE(bodies_.begin_update().none());
  bodies_.commit();
  EXPECT_EQ(bodies_.bytes(), 0U);
}

TEST_F(BodiesTest, AnUpdateTellsTheSlotsThatAreNewAndTheirBoxes) {
  ASSERT_TRUE(insert(bodies_, {9, 0xffffffff}, {box_at(1), box_at(2)}).ok());
  ASSERT_TRUE(insert(bodies_, {0}, {box_at(3)}).ok());
  EXPECT_EQ(bodies_.size(), 3U);
  const BodyChanges changes = bodies_.begin_update();
  EXPECT_THAT(changes.boxes, ElementsAre(box_at(1), box_at(2), box_at(3)));
  EXPECT_THAT(changes.inserted, ElementsAre(0U, 1U, 2U));
  EXPECT_THAT(changes.moved, IsEmpty());
  EXPECT_THAT(changes.removed, IsEmpty());
  EXPECT_EQ(changes.bodies, 3U);
  bodies_.commit();
  EXPECT_TRUE(bodies_.begin_update().none());
}

TEST_F(BodiesTest, AnUpdateTellsTheBoxesThatWereAndThoseThatAre) {
  fill(4);
  ASSERT_TRUE(move({1}, {box_at(50)}).ok());
  ASSERT_TRUE(bodies_.remove(Ids{2}).ok());
  const Shown shown = shown_in(bodies_.begin_update(), bodies_.table());
  EXPECT_THAT(shown.moved, ElementsAre(Pair(1, bits(box_at(2)))));
  EXPECT_THAT(shown.removed, ElementsAre(Pair(2, bits(box_at(4)))));
  EXPECT_EQ(shown.boxes[1], bits(box_at(50)));
  EXPECT_EQ(shown.boxes[3], bits(box_at(6)));
  EXPECT_EQ(shown.bodies, 3U);
}

TEST_F(BodiesTest, BoxesAreThoseOfTheLastUpdate) {
  fill(3);
  ASSERT_TRUE(move({1}, {box_at(50)}).ok());
  EXPECT_EQ(box_of(bodies_, 1), bits(box_at(2)));
  update(bodies_);
  EXPECT_EQ(box_of(bodies_, 1), bits(box_at(50)));
  std::vector<Aabb> boxes(4);
  ASSERT_TRUE(bodies_.boxes(Ids{2, 0, 2, 1}, boxes).ok());
  EXPECT_THAT(boxes, ElementsAre(box_at(4), box_at(0), box_at(4), box_at(50)));
}

TEST_F(BodiesTest, BoxesOfBodiesThatNoUpdateSawAreRefusedAndNothingIsWritten) {
  fill(2);
  ASSERT_TRUE(insert(bodies_, {7, 8}, {box_at(50), box_at(60)}).ok());
  std::vector<Aabb> boxes(3, box_at(-1));
  const Status unseen = bodies_.boxes(Ids{0, 8, 7}, boxes);
  EXPECT_EQ(unseen.code, StatusCode::unknown_body);
  EXPECT_THAT(unseen.bodies, ElementsAre(8U, 7U));
  EXPECT_EQ(bodies_.boxes(Ids{0, 1, 99}, boxes).code, StatusCode::unknown_body);
  EXPECT_EQ(bodies_.boxes(Ids{0, 1}, boxes).code, StatusCode::bad_input);
  EXPECT_THAT(boxes, testing::Each(box_at(-1)));
}

TEST_F(BodiesTest, BoxesBecomeCanonicalOnTheWayIn) {
  constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
  const Aabb given = {{-0.0F, kDenormal, -1}, {kDenormal, 1, -0.0F}};
  const Aabb canonical = {{0, 0, -1}, {0, 1, 0}};
  fill(2);
  ASSERT_TRUE(insert(bodies_, {5, 6}, {given, box_at(9)}).ok());
  ASSERT_TRUE(move({0}, {given}).ok());
  Ids added(1);
  ASSERT_TRUE(bodies_.add(crew_, {&given, 1}, added, "test", kAnyNumber).ok());
  update(bodies_);
  for (const BodyId id : {BodyId{0}, BodyId{5}, added[0]})
    EXPECT_EQ(box_of(bodies_, id), bits(canonical)) << id;
}

TEST_F(BodiesTest, ABodyThatNoUpdateSawIsNotMentioned) {
  fill(2);
  ASSERT_TRUE(insert(bodies_, {5, 6, 7}, boxes_from(50, 3)).ok());
  ASSERT_TRUE(move({6}, {box_at(60)}).ok());
  ASSERT_TRUE(bodies_.remove(Ids{6, 5}).ok());
  const Shown shown = shown_in(bodies_.begin_update(), bodies_.table());
  EXPECT_THAT(shown.inserted, ElementsAre(4U));
  EXPECT_THAT(shown.removed, IsEmpty());
  EXPECT_THAT(shown.moved, IsEmpty());
  EXPECT_EQ(shown.boxes[2], bits(kNobody));
  EXPECT_EQ(shown.boxes[3], bits(kNobody));
  bodies_.commit();
  ASSERT_TRUE(insert(bodies_, {8, 9}, boxes_from(70, 2)).ok());
  EXPECT_THAT(shown_by(bodies_).inserted, ElementsAre(2U, 3U)) << "their slots are free again";
}

TEST_F(BodiesTest, ANewBodyThatMovesBeginsWhereItMovedTo) {
  fill(1);
  ASSERT_TRUE(insert(bodies_, {5}, {box_at(50)}).ok());
  ASSERT_TRUE(move({5, 5}, {box_at(60), box_at(70)}).ok());
  const Shown shown = shown_by(bodies_);
  EXPECT_THAT(shown.inserted, ElementsAre(1U));
  EXPECT_THAT(shown.moved, IsEmpty());
  EXPECT_EQ(shown.boxes[1], bits(box_at(70)));
}

TEST_F(BodiesTest, ABodyThatMovedAndWasRemovedIsToldWithTheBoxItHad) {
  fill(5);
  // Whichever of those that moved is removed, first, last or in between, the others are still told.
  for (const BodyId gone : {1U, 2U, 3U}) {
    Bodies bodies;
    ASSERT_TRUE(insert(bodies, ids_from(0, 5), boxes_from(0, 5)).ok());
    update(bodies);
    ASSERT_TRUE(bodies.move(crew_, Ids{1, 2, 3}, boxes_from(50, 3)).ok());
    ASSERT_TRUE(bodies.remove({&gone, 1}).ok());
    ASSERT_TRUE(bodies.move(crew_, Ids{3, 1}, {}).code == StatusCode::bad_input);
    const Shown shown = shown_by(bodies);
    EXPECT_THAT(shown.removed, ElementsAre(Pair(gone, bits(box_at(2.0F * static_cast<float>(gone))))));
    EXPECT_EQ(shown.moved.size(), 2U);
    EXPECT_FALSE(shown.moved.contains(gone));
    for (const auto& [slot, before] : shown.moved) {
      EXPECT_EQ(before, bits(box_at(2.0F * static_cast<float>(slot))));
      EXPECT_EQ(shown.boxes[slot], bits(box_at(48.0F + 2.0F * static_cast<float>(slot))));
    }
  }
}

TEST_F(BodiesTest, ABodyThatIsReplacedIsToldAsGoneAndAsNew) {
  fill(3);
  ASSERT_TRUE(move({1}, {box_at(80)}).ok());
  ASSERT_TRUE(bodies_.remove(Ids{1}).ok());
  ASSERT_TRUE(insert(bodies_, {1}, {box_at(50)}).ok());
  ASSERT_TRUE(move({1}, {box_at(60)}).ok());
  const Shown shown = shown_in(bodies_.begin_update(), bodies_.table());
  EXPECT_THAT(shown.removed, ElementsAre(Pair(1, bits(box_at(2)))));
  EXPECT_THAT(shown.inserted, ElementsAre(3U));
  EXPECT_THAT(shown.moved, IsEmpty());
  EXPECT_EQ(shown.boxes[3], bits(box_at(60)));
  EXPECT_EQ(bodies_.table().id(1), 1U);
  bodies_.commit();
  EXPECT_EQ(box_of(bodies_, 1), bits(box_at(60)));
  EXPECT_EQ(bodies_.size(), 3U);
}

TEST_F(BodiesTest, UndoGivesEveryBoxBackBitForBit) {
  fill(40);
  ASSERT_TRUE(bodies_.remove(Ids{5, 6}).ok());
  update(bodies_);
  ASSERT_TRUE(insert(bodies_, {100, 101, 102}, boxes_from(90, 3)).ok());
  ASSERT_TRUE(move({0, 7, 39, 100}, boxes_from(200, 4)).ok());
  ASSERT_TRUE(bodies_.remove(Ids{7, 8, 102}).ok());
  const auto copy = [](std::span<const Aabb> boxes) {
    std::vector<BoxBits> all;
    for (const Aabb& box : boxes) all.push_back(bits(box));
    return all;
  };
  const std::span<const Aabb> boxes = bodies_.begin_update().boxes;
  bodies_.undo();
  const std::vector<BoxBits> before = copy(boxes);
  const Shown told = shown_by(bodies_);
  for (int attempt = 0; attempt < 3; ++attempt) {
    bodies_.begin_update();
    EXPECT_NE(copy(boxes), before);
    bodies_.undo();
    EXPECT_EQ(copy(boxes), before);
    EXPECT_EQ(shown_by(bodies_), told) << "the next update tells the same";
  }
  EXPECT_EQ(box_of(bodies_, 0), bits(box_at(0)));
}

TEST_F(BodiesTest, CallsAfterAFailedUpdateJoinThoseBefore) {
  fill(5);
  ASSERT_TRUE(insert(bodies_, {50, 51}, boxes_from(90, 2)).ok());
  ASSERT_TRUE(move({0, 1, 2}, boxes_from(200, 3)).ok());
  ASSERT_TRUE(bodies_.remove(Ids{3}).ok());
  bodies_.begin_update();
  bodies_.undo();
  ASSERT_TRUE(move({1, 4, 50}, boxes_from(300, 3)).ok());
  ASSERT_TRUE(bodies_.remove(Ids{2, 51}).ok());
  ASSERT_TRUE(move({0}, {box_at(0)}).ok());
  ASSERT_TRUE(insert(bodies_, {3}, {box_at(400)}).ok());
  const Shown shown = shown_in(bodies_.begin_update(), bodies_.table());
  EXPECT_THAT(shown.removed, ElementsAre(Pair(2, bits(box_at(4))), Pair(3, bits(box_at(6)))));
  EXPECT_THAT(shown.moved, ElementsAre(Pair(1, bits(box_at(2))), Pair(4, bits(box_at(8)))));
  EXPECT_THAT(shown.inserted, ElementsAre(5U, 7U));
  bodies_.commit();
  EXPECT_EQ(box_of(bodies_, 0), bits(box_at(0)));
  EXPECT_EQ(box_of(bodies_, 1), bits(box_at(300)));
  EXPECT_EQ(box_of(bodies_, 3), bits(box_at(400)));
  EXPECT_EQ(box_of(bodies_, 4), bits(box_at(302)));
  EXPECT_EQ(box_of(bodies_, 50), bits(box_at(304)));
}

TEST_F(BodiesTest, AnEngineThatKnowsNobodyIsToldOfAllThatAreHeld) {
  fill(6);
  ASSERT_TRUE(bodies_.remove(Ids{1}).ok());
  update(bodies_);
  ASSERT_TRUE(insert(bodies_, {70, 71, 72}, boxes_from(90, 3)).ok());
  ASSERT_TRUE(bodies_.remove(Ids{4, 71}).ok());
  ASSERT_TRUE(move({5}, {box_at(50)}).ok());
  bodies_.begin_update();
  const BodyChanges all = bodies_.all_as_new();
  EXPECT_THAT(all.inserted, ElementsAre(0U, 1U, 2U, 3U, 5U, 7U));
  EXPECT_THAT(all.moved, IsEmpty());
  EXPECT_THAT(all.removed, IsEmpty());
  EXPECT_EQ(all.bodies, 6U);
  EXPECT_EQ(all.boxes[5], box_at(50));
  EXPECT_EQ(all.boxes[1], box_at(90)) << "in the slot that was free";
  bodies_.commit();
  EXPECT_EQ(box_of(bodies_, 5), bits(box_at(50)));
}

TEST_F(BodiesTest, GiveAllMemoryBackWhenNobodyIsLeft) {
  for (const bool were_seen : {true, false}) {
    ASSERT_TRUE(insert(bodies_, ids_from(0, 3000), boxes_from(0, 3000)).ok());
    if (were_seen) update(bodies_);
    EXPECT_GT(bodies_.bytes(), 3000U * sizeof(Aabb));
    ASSERT_TRUE(bodies_.remove(ids_from(0, 3000)).ok());
    bodies_.begin_update();
    EXPECT_EQ(bodies_.size(), 0U);
    bodies_.commit();
    EXPECT_EQ(bodies_.bytes(), 0U);
    ASSERT_TRUE(insert(bodies_, {9}, {box_at(1)}).ok());
    EXPECT_THAT(shown_by(bodies_).inserted, ElementsAre(0U));
    ASSERT_TRUE(bodies_.remove(Ids{9}).ok());
    update(bodies_);
  }
}

TEST_F(BodiesTest, WhenNobodyIsLeftTheIdsOfSlotsHaveChanged) {
  fill(3);
  const std::uint64_t version = bodies_.table().version();
  ASSERT_TRUE(bodies_.remove(ids_from(0, 3)).ok());
  update(bodies_);
  EXPECT_GT(bodies_.table().version(), version);
}

TEST_F(BodiesTest, NumberSlotsAnewWhenMostAreFree) {
  fill(4000);
  EXPECT_FALSE(bodies_.tidy());
  ASSERT_TRUE(bodies_.remove(ids_from(100, 3900)).ok());
  update(bodies_);
  const std::uint64_t version = bodies_.table().version();
  ASSERT_TRUE(bodies_.remove(Ids{3}).ok());
  update(bodies_);
  ASSERT_TRUE(bodies_.tidy());
  EXPECT_LE(bodies_.bytes(), 100 * bodies_.size()) << "nothing is kept for those that have gone";
  EXPECT_GT(bodies_.table().version(), version);
  EXPECT_EQ(bodies_.size(), 99U);
  EXPECT_EQ(bodies_.table().slot_count(), 99U);
  EXPECT_EQ(box_of(bodies_, 2), bits(box_at(4)));
  EXPECT_EQ(box_of(bodies_, 99), bits(box_at(198)));
  EXPECT_FALSE(bodies_.tidy());

  ASSERT_TRUE(move({99}, {box_at(7)}).ok());
  ASSERT_TRUE(insert(bodies_, {3}, {box_at(8)}).ok());
  const Shown shown = shown_by(bodies_);
  EXPECT_THAT(shown.moved, ElementsAre(Pair(98, bits(box_at(198)))));
  EXPECT_THAT(shown.inserted, ElementsAre(99U));
}

TEST_F(BodiesTest, AddedBodiesGetIdsThatNobodyHas) {
  fill(3);
  ASSERT_TRUE(insert(bodies_, {4}, {box_at(50)}).ok());
  ASSERT_TRUE(bodies_.remove(Ids{1}).ok());
  Ids ids(3, 99);
  ASSERT_TRUE(bodies_.add(crew_, boxes_from(60, 3), ids, "test", kAnyNumber).ok());
  for (const BodyId id : ids) EXPECT_THAT((Ids{0, 1, 2, 4, 99}), testing::Not(testing::Contains(id)));
  EXPECT_EQ(bodies_.size(), 6U);
  update(bodies_);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(box_of(bodies_, ids[i]), bits(boxes_from(60, 3)[i]));
  ids.resize(1);
  ASSERT_TRUE(bodies_.add(crew_, boxes_from(60, 1), ids, "test", kAnyNumber).ok());
  EXPECT_THAT(ids, ElementsAre(1U)) << "its pairs have ended";
}

}  // namespace
}  // namespace cellsweep
