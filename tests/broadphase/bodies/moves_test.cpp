/// @file
/// Moves in any order, in shares of several workers, with bodies listed twice: the last box counts.
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "base/threads/thread_pool.h"
#include "broadphase/bodies/shown.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

constexpr std::size_t kBodies = 200;

/// Bodies 0 ... 199, each at twice its number, and workers that check moves.
class MovesTest : public testing::TestWithParam<unsigned> {
 protected:
  void SetUp() override {
    ASSERT_TRUE(insert(bodies_, all_, boxes_).ok());
    update(bodies_);
  }

  void move(const Ids& ids, const std::vector<Aabb>& boxes) {
    const Status status = bodies_.move(crew_, ids, boxes);
    ASSERT_TRUE(status.ok()) << status.message;
  }

  /// Slots that are told as moved, whether or not their boxes differ.
  std::size_t listed() {
    const std::size_t count = bodies_.begin_update().moved.size();
    bodies_.undo();
    return count;
  }

  const Ids all_ = ids_from(0, kBodies);
  const std::vector<Aabb> boxes_ = boxes_from(0, kBodies);
  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
  Bodies bodies_;
};

TEST_P(MovesTest, ToWhereBodiesAreMoveNobody) {
  for (int call = 0; call < 3; ++call) {
    move(all_, boxes_);
    EXPECT_EQ(listed(), 0U);
  }
  move({7}, {boxes_[7]});
  move({3, 4, 9, 150}, {boxes_[3], boxes_[4], boxes_[9], boxes_[150]});
  EXPECT_EQ(listed(), 0U);
}

TEST_P(MovesTest, OfAllBodiesAreTold) {
  const std::vector<Aabb> next = boxes_from(0.5F, kBodies);
  move(all_, next);
  EXPECT_EQ(listed(), kBodies);
  const Shown shown = shown_in(bodies_.begin_update(), bodies_.table());
  ASSERT_EQ(shown.moved.size(), kBodies);
  for (Slot slot = 0; slot < kBodies; ++slot) {
    EXPECT_EQ(shown.moved.at(slot), bits(boxes_[slot]));
    EXPECT_EQ(shown.boxes[slot], bits(next[slot]));
  }
  bodies_.commit();
  EXPECT_EQ(listed(), 0U);
}

TEST_P(MovesTest, InDescendingOrderAreAsGood) {
  const Ids ids(all_.rbegin(), all_.rend());
  const std::vector<Aabb> next = boxes_from(0.5F, kBodies);
  for (int round = 0; round < 2; ++round) {
    move(ids, {next.rbegin(), next.rend()});
    update(bodies_);
    for (const BodyId id : ids) ASSERT_EQ(box_of(bodies_, id), bits(next[id]));
    move(ids, {boxes_.rbegin(), boxes_.rend()});
    update(bodies_);
    for (const BodyId id : ids) ASSERT_EQ(box_of(bodies_, id), bits(boxes_[id]));
  }
}

TEST_P(MovesTest, InDescendingOrderToWhereBodiesAreMoveNobody) {
  for (int call = 0; call < 3; ++call) {
    move({all_.rbegin(), all_.rend()}, {boxes_.rbegin(), boxes_.rend()});
    EXPECT_EQ(listed(), 0U);
  }
}

TEST_P(MovesTest, ToWhereBodiesAreMoveNobodyThoughTheCallBeforeWasInAnotherOrder) {
  move({9, 8}, {box_at(1000), box_at(1002)});
  update(bodies_);
  std::vector<Aabb> boxes = boxes_;
  boxes[9] = box_at(1000);
  boxes[8] = box_at(1002);
  move(all_, boxes);
  EXPECT_EQ(listed(), 0U);
}

TEST_P(MovesTest, OfOneBodyToSeveralPlacesEndAtTheLast) {
  move({5, 5, 5}, {box_at(1000), box_at(1002), box_at(1004)});
  EXPECT_THAT(shown_by(bodies_).moved, ElementsAre(Pair(5, bits(boxes_[5]))));
  move({5}, {box_at(1006)});
  update(bodies_);
  EXPECT_EQ(box_of(bodies_, 5), bits(box_at(1006)));
}

TEST_P(MovesTest, ThatEndWhereTheBodyWasMoveNobody) {
  for (const bool descending_before : {false, true}) {
    if (descending_before) move({2, 1}, {boxes_[2], boxes_[1]});
    move({5, 5}, {box_at(1000), boxes_[5]});
    move({6, 5, 6}, {box_at(1000), boxes_[5], boxes_[6]});
    move({7}, {box_at(1000)});
    move({7}, {boxes_[7]});
    EXPECT_THAT(shown_by(bodies_).moved, IsEmpty());
    update(bodies_);
    for (const BodyId id : {5U, 6U, 7U}) EXPECT_EQ(box_of(bodies_, id), bits(boxes_[id]));
  }
}

TEST_P(MovesTest, ThatComeByWhereTheBodyWasEndAtTheLast) {
  for (const bool descending_before : {false, true}) {
    if (descending_before) move({2, 1}, {boxes_[2], boxes_[1]});
    move({5, 5}, {boxes_[5], box_at(1000)});
    move({6, 6, 6}, {box_at(1002), boxes_[6], box_at(1004)});
    const Shown shown = shown_by(bodies_);
    EXPECT_THAT(shown.moved, ElementsAre(Pair(5, bits(boxes_[5])), Pair(6, bits(boxes_[6]))));
    EXPECT_EQ(shown.boxes[5], bits(box_at(1000)));
    EXPECT_EQ(shown.boxes[6], bits(box_at(1004)));
    move({5, 6}, {boxes_[5], boxes_[6]});
  }
}

// Whichever worker checks the first of them and whichever the second.
TEST_P(MovesTest, OfABodyThatIsListedTwiceAnywhereEndAtTheLast) {
  for (const std::size_t first : {0, 1, 66, 67, 100}) {
    for (const std::size_t second : {101, 133, 134, 199}) {
      for (const bool back : {false, true}) {
        Ids ids = all_;
        std::vector<Aabb> next = boxes_;
        ids[second] = static_cast<BodyId>(first);
        next[first] = box_at(1000);
        next[second] = back ? boxes_[first] : box_at(1002);
        move(ids, next);
        const Shown shown = shown_by(bodies_);
        if (back) {
          EXPECT_THAT(shown.moved, IsEmpty());
        } else {
          EXPECT_THAT(shown.moved, ElementsAre(Pair(first, bits(boxes_[first]))));
          EXPECT_EQ(shown.boxes[first], bits(box_at(1002)));
        }
        move(all_, boxes_);
        ASSERT_THAT(shown_by(bodies_).moved, IsEmpty());
      }
    }
  }
}

TEST_P(MovesTest, OfBodiesInSlotsOfOthersAreTheirOwn) {
  ASSERT_TRUE(bodies_.remove(ids_from(50, 40)).ok());
  update(bodies_);
  Ids ids = ids_from(1'000'000, 40);
  std::reverse(ids.begin(), ids.end());
  ASSERT_TRUE(insert(bodies_, ids, boxes_from(2000, 40)).ok());
  update(bodies_);
  move(ids, boxes_from(3000, 40));
  update(bodies_);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(box_of(bodies_, ids[i]), bits(boxes_from(3000, 40)[i]));
  EXPECT_EQ(box_of(bodies_, 49), bits(boxes_[49]));
  EXPECT_EQ(box_of(bodies_, 90), bits(boxes_[90]));
}

TEST_P(MovesTest, OfNewBodiesAndOldOnesInOneCallAreEachRight) {
  ASSERT_TRUE(insert(bodies_, ids_from(500, 60), boxes_from(2000, 60)).ok());
  Ids ids;
  for (BodyId i = 0; i < 60; ++i) ids.insert(ids.end(), {500 + i, i});
  move(ids, boxes_from(3000, 120));
  const Shown shown = shown_by(bodies_);
  EXPECT_EQ(shown.inserted.size(), 60U);
  EXPECT_EQ(shown.moved.size(), 60U);
  update(bodies_);
  for (std::size_t i = 0; i < 120; ++i) EXPECT_EQ(box_of(bodies_, ids[i]), bits(boxes_from(3000, 120)[i]));
}

TEST_P(MovesTest, OfRandomCallsEndWhereTheLastOfEachBodyLed) {
  Random random(1);
  const Ids scattered = ids_from(0xfffffff0, 16);
  ASSERT_TRUE(insert(bodies_, scattered, boxes_from(5000, 16)).ok());
  update(bodies_);
  Ids held = all_;
  held.insert(held.end(), scattered.begin(), scattered.end());
  std::map<BodyId, Aabb> truth;
  for (const BodyId id : held)
    truth[id] = id < kBodies ? boxes_[id] : box_at(5000 + 2 * static_cast<float>(id - scattered[0]));
  for (int call = 0; call < 400; ++call) {
    Ids ids;
    std::vector<Aabb> next;
    const std::size_t count = random.one_in(3) ? kBodies : 1 + random.below(90);
    const std::size_t first = random.below(held.size());
    for (std::size_t i = 0; i < count; ++i) {
      const bool in_order = call % 4 != 0 && !random.one_in(50);
      ids.push_back(in_order ? held[(first + i) % held.size()] : random.pick(held));
      next.push_back(random.one_in(4) ? box_at(static_cast<float>(random.whole(0, 9))) : truth[ids.back()]);
    }
    move(ids, next);
    for (std::size_t i = 0; i < ids.size(); ++i) truth[ids[i]] = next[i];
    if (!random.one_in(3)) continue;
    update(bodies_);
    for (const auto& [id, box] : truth)
      ASSERT_EQ(box_of(bodies_, id), bits(box)) << "body " << id << ", call " << call;
  }
}

/// Bodies whose table waits, told in another order than they came in.
TEST_P(MovesTest, OfBodiesWithoutATableInAnyOrderAreTold) {
  for (const std::size_t moved : {1, 40, 5000}) {
    Ids ids(5000);
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<BodyId>((i + 1) * 2'654'435'761U);
    bodies_ = Bodies();
    ASSERT_TRUE(insert(bodies_, ids, boxes_from(0, ids.size())).ok());
    update(bodies_);
    ASSERT_FALSE(bodies_.table().has_table());
    EXPECT_FALSE(bodies_.move(crew_, Ids{5}, boxes_from(0, 1)).ok());
    std::ranges::reverse(ids);
    move({ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(moved)}, boxes_from(100'000, moved));
    EXPECT_EQ(listed(), moved);
    EXPECT_TRUE(bodies_.table().has_table());
  }
}

INSTANTIATE_TEST_SUITE_P(Workers, MovesTest, testing::Values(1U, 2U, 3U));

}  // namespace
}  // namespace cellsweep
