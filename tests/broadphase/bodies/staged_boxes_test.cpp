/// @file
/// Boxes of the last update and of the next, against plain arrays, when few move and when most do.
#include "broadphase/bodies/staged_boxes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "base/memory/starved.h"
#include "base/threads/numbers_of_workers.h"
#include "base/threads/thread_pool.h"
#include "base/tuning.h"
#include "broadphase/bodies/shown.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::vector<Slot> slots_from(Slot first, std::size_t count) {
  std::vector<Slot> slots(count);
  std::iota(slots.begin(), slots.end(), first);
  return slots;
}

/// A thousand bodies at rest, each at twice its number.
class StagedBoxesTest : public testing::TestWithParam<unsigned> {
 protected:
  static constexpr std::size_t kBodies = 1000;
  static constexpr std::size_t kFew = kBodies / (2 * kSlotBlock);

  void SetUp() override {
    boxes_.reserve(kBodies);
    boxes_.insert(all_, boxes_from(0, kBodies));
    boxes_.begin_update();
    boxes_.commit(all_);
  }

  void move(const std::vector<Slot>& slots, const std::vector<Aabb>& boxes, bool clean = true) {
    const bool ascends = std::ranges::adjacent_find(slots, std::greater_equal<>()) == slots.end();
    boxes_.move(crew_, {slots, boxes, clean, ascends});
  }

  /// What a next update tells, without making one.
  std::vector<Slot> moved() {
    const BodyChanges changes = boxes_.begin_update();
    const std::vector<Slot> slots(changes.moved.begin(), changes.moved.end());
    boxes_.undo();
    return slots;
  }

  const std::vector<Slot> all_ = slots_from(0, kBodies);
  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
  StagedBoxes boxes_;
};

INSTANTIATE_TEST_SUITE_P(Workers, StagedBoxesTest, numbers_of_workers());

TEST_P(StagedBoxesTest, ShowNothingOfThoseThatAreStagedBeforeTheyAreInserted) {
  const std::vector<Aabb> boxes = boxes_from(700, 1000);
  boxes_.reserve(kBodies + boxes.size());
  ASSERT_TRUE(boxes_.stage(crew_, boxes_from(-700, 5)));
  ASSERT_TRUE(boxes_.stage(crew_, boxes));
  EXPECT_EQ(boxes_.slots(), kBodies);
  boxes_.insert_staged(boxes.size());
  ASSERT_EQ(boxes_.slots(), kBodies + boxes.size());
  for (Slot i = 0; i < boxes.size(); ++i) {
    ASSERT_EQ(bits(boxes_.boxes()[kBodies + i]), bits(boxes[i]));
    ASSERT_EQ(boxes_.state(kBodies + i), kInserted);
  }
}

TEST_P(StagedBoxesTest, SayWhereverItStandsThatABoxIsNotCleanAsItIs) {
  const std::vector<Aabb> boxes = boxes_from(700, 300);
  boxes_.reserve(kBodies + boxes.size());
  for (std::size_t place = 0; place < boxes.size(); ++place) {
    for (const float value : {-0.0F, 1e-44F, -1e9F, std::numeric_limits<float>::quiet_NaN()}) {
      std::vector<Aabb> given = boxes;
      given[place].max[place % 3] = value;
      ASSERT_FALSE(boxes_.stage(crew_, given)) << place << ": " << value;
    }
  }
}

TEST_P(StagedBoxesTest, MoveNobodyWhoIsToldToStay) {
  move(all_, boxes_from(0, kBodies));
  move({7, 3}, {box_at(14), box_at(6)});
  EXPECT_THAT(moved(), IsEmpty());
}

TEST_P(StagedBoxesTest, TellEveryBodyThatMovesWhereverItStands) {
  for (Slot mover = 0; mover < kBodies; ++mover) {
    std::vector<Aabb> next = boxes_from(0, kBodies);
    next[mover] = box_at(-5);
    move(all_, next);
    EXPECT_THAT(moved(), testing::Contains(mover));
    const BodyChanges changes = boxes_.begin_update();
    EXPECT_EQ(bits(changes.boxes[mover]), bits(box_at(-5)));
    EXPECT_EQ(bits(changes.before[mover]), bits(box_at(2.0F * static_cast<float>(mover))));
    boxes_.undo();
    move({mover}, {box_at(2.0F * static_cast<float>(mover))});
    boxes_.begin_update();
    boxes_.commit({});
  }
}

TEST_P(StagedBoxesTest, KeepTheLastOfSeveralBoxes) {
  move({5, 5, 6, 5}, {box_at(1), box_at(2), box_at(3), box_at(4)});
  move({6}, {box_at(5)});
  EXPECT_THAT(moved(), UnorderedElementsAre(5, 6));
  const BodyChanges changes = boxes_.begin_update();
  EXPECT_EQ(bits(changes.boxes[5]), bits(box_at(4)));
  EXPECT_EQ(bits(changes.boxes[6]), bits(box_at(5)));
  EXPECT_EQ(bits(changes.before[5]), bits(box_at(10)));
}

TEST_P(StagedBoxesTest, TakeBoxesInTheirCanonicalForm) {
  const float denormal = std::numeric_limits<float>::denorm_min();
  const Aabb zero{{0, 0, 0}, {0, 1, 1}};
  move({0, 1, 2}, {{{-0.0F, denormal, 0}, {denormal, 1, 1}}, zero, box_at(4)}, false);
  const BodyChanges changes = boxes_.begin_update();
  EXPECT_THAT(changes.moved, ElementsAre(0, 1));
  EXPECT_EQ(bits(changes.boxes[0]), bits(zero));
}

TEST_P(StagedBoxesTest, TellAMovedBodyThatIsRemovedAsRemoved) {
  move(slots_from(0, 5), boxes_from(50, 5));
  boxes_.reserve_removals(2);
  boxes_.remove(2);
  boxes_.remove(77);
  for (int attempt = 0; attempt < 2; ++attempt) {
    const BodyChanges changes = boxes_.begin_update();
    EXPECT_THAT(changes.moved, ElementsAre(0, 1, 3, 4));
    EXPECT_THAT(changes.removed, ElementsAre(2, 77));
    for (const Slot slot : {2U, 77U}) {
      EXPECT_EQ(bits(changes.boxes[slot]), bits(kNobody));
      EXPECT_EQ(bits(changes.before[slot]), bits(box_at(2.0F * static_cast<float>(slot))));
    }
    boxes_.undo();
    EXPECT_EQ(bits(boxes_.boxes()[2]), bits(box_at(4))) << "an update that failed shows nothing";
  }
}

// A box for each that moves, and its neighbours by slot; for all only while many do.
TEST_P(StagedBoxesTest, TakeMemoryForBoxesOfThoseThatChangeOnly) {
  const std::size_t at_rest = boxes_.bytes();
  const auto bytes_while = [&](std::size_t movers) {
    move(slots_from(0, movers), boxes_from(-500, movers));
    const std::size_t bytes = boxes_.bytes() - at_rest;
    boxes_.begin_update();
    boxes_.commit({});
    return bytes;
  };
  const std::size_t of_few = bytes_while(kFew);
  EXPECT_GT(of_few, 0U);
  EXPECT_LE(of_few, kBodies * sizeof(Aabb) * 3 / 4);
  EXPECT_GE(bytes_while(kBodies / 2), kBodies * sizeof(Aabb));
  for (std::uint32_t quiet = 1; quiet < tuning::kQuietToGiveBack; ++quiet) {
    EXPECT_FALSE(boxes_.has_come_to_rest());
    EXPECT_GE(boxes_.bytes() - at_rest, kBodies * sizeof(Aabb));
    move({5}, {box_at(static_cast<float>(quiet))});
    boxes_.begin_update();
    boxes_.commit({});
  }
  EXPECT_TRUE(boxes_.has_come_to_rest());
  EXPECT_EQ(boxes_.bytes(), at_rest);
  EXPECT_THAT(moved(), IsEmpty());
  move({kBodies - 1, 5}, {box_at(1), box_at(2)});
  EXPECT_THAT(moved(), ElementsAre(kBodies - 1, 5));
}

// Few moves that wait for the update go on by slot with many.
TEST_P(StagedBoxesTest, KeepWhatFewMovedToWhenManyDo) {
  move({3, 900}, {box_at(-1), box_at(-2)});
  boxes_.reserve_removals(1);
  boxes_.remove(77);
  std::vector<Slot> many = slots_from(100, 400);
  move(many, boxes_from(5000, many.size()));
  for (int attempt = 0; attempt < 2; ++attempt) {
    const BodyChanges changes = boxes_.begin_update();
    EXPECT_EQ(bits(changes.boxes[3]), bits(box_at(-1)));
    EXPECT_EQ(bits(changes.boxes[900]), bits(box_at(-2)));
    EXPECT_EQ(bits(changes.before[900]), bits(box_at(1800)));
    EXPECT_EQ(bits(changes.boxes[77]), bits(kNobody));
    EXPECT_EQ(bits(changes.before[77]), bits(box_at(154)));
    EXPECT_EQ(changes.moved.size(), 402U);
    boxes_.undo();
  }
}

TEST_P(StagedBoxesTest, AreAsTheyWereWhereverMemoryEnds) {
  for (const std::size_t movers : {std::size_t{1}, kFew, kBodies / 2}) {
    bool failed = true;
    for (std::uint64_t nth = 1; failed; ++nth) {
      StagedBoxes boxes;
      boxes.reserve(kBodies);
      boxes.insert(all_, boxes_from(0, kBodies));
      boxes.begin_update();
      boxes.commit(all_);
      const auto slots = slots_from(2, movers);
      const auto next = boxes_from(-900, movers);
      failed = fails_at(nth, [&] { boxes.move(crew_, {slots, next, true, true}); });
      const BodyChanges changes = boxes.begin_update();
      EXPECT_EQ(changes.moved.size(), failed ? 0 : movers);
      for (Slot slot = 0; slot < kBodies; ++slot) {
        const bool has_moved = !failed && slot >= 2 && slot < 2 + movers;
        ASSERT_EQ(bits(changes.boxes[slot]),
                  bits(has_moved ? next[slot - 2] : box_at(2.0F * static_cast<float>(slot))));
      }
    }
  }
}

/// Random calls, and plain arrays of what they should have led to.
class RandomStages : public StagedBoxesTest {
 protected:
  /// Most of the bodies, or few; some stay, or go back to where they were.
  void move_some() {
    std::vector<Slot> slots = slots_from(0, next_.size());
    std::erase_if(slots, [&](Slot slot) { return bits(next_[slot]) == bits(kNobody); });
    if (random_.one_in(2)) random_.shuffle(slots);
    if (random_.one_in(2)) slots.resize(random_.below(random_.one_in(2) ? kFew : slots.size()));
    std::vector<Aabb> boxes;
    for (const Slot slot : slots)
      boxes.push_back(random_.one_in(4) ? seen_[slot] : box_at(static_cast<float>(random_.whole(0, 9))));
    move(slots, boxes);
    for (std::size_t i = 0; i < slots.size(); ++i) {
      next_[slots[i]] = boxes[i];
      if (is_new(slots[i])) seen_[slots[i]] = boxes[i];
    }
  }

  void insert_one() {
    const auto slot = static_cast<Slot>(next_.size());
    boxes_.reserve(next_.size() + 1);
    boxes_.insert({&slot, 1}, {{box_at(1)}});
    next_.push_back(box_at(1));
    seen_.push_back(box_at(1));
    inserted_.push_back(slot);
  }

  void remove_one() {
    const auto slot = static_cast<Slot>(random_.below(next_.size()));
    if (bits(next_[slot]) == bits(kNobody) || is_new(slot)) return;
    boxes_.reserve_removals(1);
    boxes_.remove(slot);
    next_[slot] = kNobody;
    removed_.insert(slot);
  }

  void expect_seen() const {
    for (Slot slot = 0; slot < seen_.size(); ++slot)
      ASSERT_EQ(bits(boxes_.boxes()[slot]), bits(seen_[slot])) << slot;
  }

  void expect_told(const BodyChanges& changes) const {
    const std::set<Slot> gone(changes.removed.begin(), changes.removed.end());
    ASSERT_THAT(gone, testing::ContainerEq(removed_));
    const std::set<Slot> told(changes.moved.begin(), changes.moved.end());
    ASSERT_EQ(told.size(), changes.moved.size());
    for (Slot slot = 0; slot < next_.size(); ++slot) {
      ASSERT_EQ(bits(changes.boxes[slot]), bits(next_[slot])) << slot;
      const bool changed = told.contains(slot) || gone.contains(slot);
      ASSERT_EQ(bits(changed ? changes.before[slot] : next_[slot]), bits(seen_[slot])) << slot;
    }
  }

  void commit() {
    boxes_.commit(inserted_);
    seen_ = next_;
    inserted_.clear();
    removed_.clear();
  }

  Random random_{GetParam()};

 private:
  bool is_new(Slot slot) const { return std::ranges::find(inserted_, slot) != inserted_.end(); }

  std::vector<Aabb> seen_ = boxes_from(0, kBodies);  // by the last update
  std::vector<Aabb> next_ = seen_;
  std::vector<Slot> inserted_;
  std::set<Slot> removed_;
};

TEST_P(RandomStages, HoldWhatPlainArraysHold) {
  for (int round = 0; round < 2000 && !HasFatalFailure(); ++round) {
    if (random_.one_in(2)) move_some();
    if (random_.one_in(4)) insert_one();
    if (random_.one_in(4)) remove_one();
    expect_seen();
    if (random_.one_in(2)) continue;
    expect_told(boxes_.begin_update());
    if (random_.one_in(3)) {
      boxes_.undo();
    } else {
      commit();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Workers, RandomStages, numbers_of_workers());

}  // namespace
}  // namespace cellsweep
