/// @file
/// What a worker finds out about its share of a move(): bodies in runs or anywhere, boxes good or bad.
#include "broadphase/bodies/move_check.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

#include "base/tuning.h"
#include "broadphase/bodies/shown.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

/// Bodies in a table, and one check of a call.
class MoveCheckTest : public testing::Test {
 protected:
  void hold(const Ids& ids) {
    List<Slot> slots;
    ASSERT_TRUE(table_.insert(ids, slots));
    held_.reserve(table_.slot_count());
    held_.insert(slots, boxes_from(1000, ids.size()));
    held_.begin_update();
    held_.commit(slots);
  }
  void remove(BodyId id) {
    const Slot slot = table_.find(id);
    table_.reserve_removals(1);
    table_.remove(slot);
    held_.reserve_removals(1);
    held_.remove(slot);
  }

  /// All of the call, as one share, with `slots_` as the guess. What is found is in `slots_`.
  void run(const Ids& ids, const std::vector<Aabb>& boxes) { run(ids, boxes, {0, ids.size()}); }
  void run(const Ids& ids) { run(ids, boxes_from(0, ids.size())); }
  void run(const Ids& ids, const std::vector<Aabb>& boxes, Share share) {
    slots_.resize(ids.size(), kNoSlot);
    check_.run({table_, held_}, ids, boxes, share, slots_.data());
  }

  void expect_right(const Ids& ids) const {
    ASSERT_TRUE(check_.good());
    ASSERT_EQ(slots_.size(), ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) ASSERT_EQ(slots_[i], table_.find(ids[i])) << "body " << i;
    if (ids.empty()) return;
    EXPECT_EQ(check_.first(), slots_.front());
    EXPECT_EQ(check_.last(), slots_.back());
    EXPECT_EQ(check_.ascends(), std::ranges::adjacent_find(slots_, std::greater_equal<>()) == slots_.end());
  }

  IdTable table_;
  StagedBoxes held_;
  MoveCheck check_;
  std::vector<Slot> slots_;
};

TEST_F(MoveCheckTest, OfNobodyIsGood) {
  hold(ids_from(0, 3));
  run({});
  EXPECT_TRUE(check_.good());
  EXPECT_TRUE(check_.ascends());
}

TEST_F(MoveCheckTest, FindsTheSlotsOfAllInOrder) {
  hold(ids_from(0, 100));
  run(ids_from(0, 100));
  expect_right(ids_from(0, 100));
  EXPECT_TRUE(check_.clean());
}

TEST_F(MoveCheckTest, SaysWhetherAnybodyMoves) {
  const Ids ids = ids_from(0, 100);
  hold(ids);
  const std::vector<Aabb> boxes = boxes_from(1000, 100);
  run(ids, boxes);
  EXPECT_TRUE(check_.nobody_moves());
  for (std::size_t mover = 0; mover < 100; ++mover) {
    std::vector<Aabb> next = boxes;
    next[mover].max[2] = 2;
    run(ids, next);
    EXPECT_FALSE(check_.nobody_moves()) << mover;
  }
  Crew crew(nullptr, 1, Crew::Choice::given);
  const Slot moved = 50;
  held_.move(crew, {{&moved, 1}, {{box_at(3)}}, true, true});
  run(ids, boxes);
  EXPECT_FALSE(check_.nobody_moves()) << "it moved away, and is told to stay";
}

TEST_F(MoveCheckTest, SaysThatABoxIsNotCanonical) {
  constexpr float kSmallest = std::numeric_limits<float>::denorm_min();
  hold(ids_from(0, 40));
  for (const std::size_t place : {0, 1, 31, 32, 39}) {
    std::vector<Aabb> boxes = boxes_from(0, 40);
    boxes[place] = {{-0.0F, kSmallest, -1}, {kSmallest, 1, -0.0F}};
    run(ids_from(0, 40), boxes);
    expect_right(ids_from(0, 40));
    EXPECT_FALSE(check_.clean()) << place;
  }
}

TEST_F(MoveCheckTest, IsNotGoodWithAnInvalidBoxOrAnUnknownBodyWhereverItStands) {
  const Ids ids = ids_from(0, 100);
  hold(ids);
  for (std::size_t bad = 0; bad < 100; ++bad) {
    std::vector<Aabb> boxes = boxes_from(0, 100);
    boxes[bad].max[bad % 3] = bad % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : -1e9F;
    run(ids, boxes);
    EXPECT_FALSE(check_.good()) << bad;
    Ids bad_ids = ids;
    bad_ids[bad] = bad % 2 == 0 ? 100 : 0xffffffff;
    run(bad_ids);
    EXPECT_FALSE(check_.good()) << bad;
  }
}

TEST_F(MoveCheckTest, DoesNotTakeARemovedBodyForOneOfARun) {
  const Ids ids = ids_from(0, 100);
  for (const BodyId gone : {0U, 40U, 99U}) {
    table_ = {};
    held_ = {};
    slots_.clear();
    hold(ids);
    run(ids);
    remove(gone);
    run(ids);
    EXPECT_FALSE(check_.good()) << gone;
    hold({gone});
    run(ids);
    expect_right(ids);
    EXPECT_EQ(slots_[gone], 100U) << "it came back in another slot";
  }
}

TEST_F(MoveCheckTest, TakesNoGuessThatIsWrong) {
  const Ids ids = {9, 1'000'000, 7, 2, 0xffffffff, 3};
  hold(ids);
  const Ids call = {3, 0xffffffff, 9, 7};
  for (const std::vector<Slot>& guess : std::vector<std::vector<Slot>>{
           {5, 4, 0, 2}, {5, 4, 0, 1}, {0, 0, 0, 0}, {kNoSlot, 6, 7, 8}, {5, 4, 0, kNoSlot}}) {
    slots_ = guess;
    run(call);
    expect_right(call);
  }
  remove(9);
  slots_ = {5, 4, 0, 2};
  run(call);
  EXPECT_FALSE(check_.good()) << "the slot still has the removed body's id";
}

TEST_F(MoveCheckTest, SaysWhetherSlotsAscend) {
  hold({5, 1'000'000, 7, 2, 0xffffffff, 3});
  const auto ascends = [&](const Ids& ids) {
    slots_.clear();
    run(ids);
    expect_right(ids);
    return check_.ascends();
  };
  EXPECT_TRUE(ascends({5}));
  EXPECT_TRUE(ascends({5, 1'000'000, 7, 2, 0xffffffff, 3}));
  EXPECT_TRUE(ascends({1'000'000, 2, 3}));
  EXPECT_FALSE(ascends({7, 1'000'000}));
  EXPECT_FALSE(ascends({5, 5}));
  EXPECT_FALSE(ascends({1'000'000, 7, 2, 7}));
}

TEST_F(MoveCheckTest, SeesABodyListedTwiceThoughRunsLieBetween) {
  hold(ids_from(0, 200));
  for (const std::size_t place : {1, 31, 32, 33, 64, 149}) {
    Ids twice = ids_from(0, 150);
    twice[place] = 0;
    run(twice);
    EXPECT_FALSE(check_.ascends()) << place;
  }
}

TEST_F(MoveCheckTest, LooksAtItsShareAlone) {
  hold(ids_from(0, 100));
  Ids ids = ids_from(0, 100);
  ids[10] = 5000;
  ids[90] = 5000;
  std::vector<Aabb> boxes(100, box_at(-9));
  boxes[91] = kNobody;
  run(ids, boxes, {20, 85});
  ASSERT_TRUE(check_.good());
  EXPECT_EQ(check_.first(), 20U);
  EXPECT_EQ(check_.last(), 84U);
  for (Slot i = 0; i < 100; ++i) EXPECT_EQ(slots_[i], i >= 20 && i < 85 ? i : kNoSlot);
  run(ids, boxes, {50, 50});
  EXPECT_TRUE(check_.good());
}

// Each call's slots are the next one's guess.
TEST_F(MoveCheckTest, FindsEveryBodyOfRandomCalls) {
  contract::Random random(1);
  Ids held = ids_from(0, 70);
  for (BodyId i = 0; i < 60; ++i) held.push_back(i * 71'582'788 + 70);
  hold(held);
  for (int call = 0; call < 500; ++call) {
    Ids ids;
    while (ids.size() < 120) {
      const std::size_t first = random.below(held.size());
      const std::size_t count = std::min(random.one_in(3) ? 1 + random.below(50) : 1, held.size() - first);
      ids.insert(ids.end(), held.begin() + static_cast<std::ptrdiff_t>(first),
                 held.begin() + static_cast<std::ptrdiff_t>(first + count));
    }
    const int times = random.whole(1, 3);
    for (int time = 0; time < times; ++time) {
      run(ids);
      expect_right(ids);
    }
  }
}

TEST_F(MoveCheckTest, NeedsATableOnlyToLookBodiesUp) {
  Ids ids(tuning::kTableWaits);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<BodyId>((i + 1) * 2'654'435'761U);
  hold(ids);
  const std::vector<Aabb> boxes = boxes_from(0, ids.size());
  for (const Share share : {Share{0, 333}, Share{333, ids.size()}}) {
    run(ids, boxes, share);
    EXPECT_TRUE(check_.good());
  }
  EXPECT_THAT(slots_, testing::ElementsAreArray(ids_from(0, ids.size())));
  EXPECT_FALSE(table_.has_table());
  std::ranges::reverse(ids);
  slots_.clear();
  run(ids);
  EXPECT_TRUE(table_.has_table());
  expect_right(ids);
}

}  // namespace
}  // namespace cellsweep
