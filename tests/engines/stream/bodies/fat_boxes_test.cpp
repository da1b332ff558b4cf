/// @file
/// Which fat boxes an update changes, and that each encloses its box all the time.
#include "engines/stream/bodies/fat_boxes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "base/threads/numbers_of_workers.h"
#include "base/threads/thread_pool.h"
#include "cellsweep/engine/engine.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using testing::IsEmpty;
using Extent = FatBoxes::Extent;

constexpr std::size_t kAny = 1'000'000;

bool same(const Aabb& one, const Aabb& other) {
  return std::memcmp(&one, &other, sizeof(Aabb)) == 0;
}

bool encloses(const Aabb& hull, const Aabb& box) {
  bool enclosed = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    enclosed = enclosed && hull.min[axis] <= box.min[axis] && box.max[axis] <= hull.max[axis];
  return enclosed;
}

Aabb along_x(const Aabb& box, float by) {
  return {{box.min[0] + by, box.min[1], box.min[2]}, {box.max[0] + by, box.max[1], box.max[2]}};
}

/// Bodies by slot, what happens to them, and the fat boxes as the changes so far say that they are.
class FatBoxesTest : public testing::TestWithParam<unsigned> {
 protected:
  void insert(Slot slot, const Aabb& box) {
    if (slot >= boxes_.size()) boxes_.resize(slot + 1, kNobody);
    boxes_[slot] = box;
    inserted_.push_back(slot);
  }
  void insert(const std::vector<Aabb>& boxes) {
    for (const Aabb& box : boxes) insert(static_cast<Slot>(boxes_.size()), box);
  }
  void move(Slot slot, const Aabb& box) {
    boxes_[slot] = box;
    moved_.push_back(slot);
  }
  void remove(Slot slot) {
    boxes_[slot] = kNobody;
    removed_.push_back(slot);
  }

  std::size_t bodies() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(boxes_, [](const Aabb& box) { return !std::isnan(box.min[0]); }));
  }

  /// Hands over what happened. Checks what is listed, and that fat boxes enclose boxes.
  Extent take(std::size_t most_listed = kAny) {
    const Extent extent = fat_.take(crew_, changes(), {.most_listed = most_listed});
    if (extent == Extent::listed) apply(fat_.changes());
    end_update(extent);
    return extent;
  }
  /// The same, and they are made anew.
  void refit() {
    fat_.refit(crew_, changes());
    end_update(Extent::all);
  }

  BodyChanges changes() const { return {boxes_, {before_}, removed_, moved_, inserted_, bodies()}; }

  void end_update(Extent extent) {
    known_.resize(boxes_.size(), kNobody);
    for (Slot slot = 0; slot < boxes_.size(); ++slot) {
      const Aabb& fat = fat_.of(slot, boxes_[slot]);
      if (extent == Extent::all) known_[slot] = fat;
      EXPECT_TRUE(same(fat, known_[slot])) << "slot " << slot << " has a fat box that was not listed";
      EXPECT_TRUE(std::isnan(boxes_[slot].min[0]) ? same(fat, kNobody) : encloses(fat, boxes_[slot]));
    }
    before_ = boxes_;
    moved_.clear();
    removed_.clear();
    inserted_.clear();
  }

  std::size_t listed() const { return fat_.changes().size(); }

  /// The fat box as it is.
  const Aabb& fat(Slot slot) const { return known_[slot]; }

  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
  FatBoxes fat_;
  std::vector<Aabb> boxes_;

 private:
  void apply(std::span<const FatBoxChange> changes) {
    known_.resize(boxes_.size(), kNobody);
    std::set<Slot> slots;
    for (const FatBoxChange& change : changes) {
      EXPECT_TRUE(slots.insert(change.slot).second) << "a slot is listed twice";
      EXPECT_TRUE(change.was || change.is);
      EXPECT_TRUE(same(change.old_box, known_[change.slot])) << "slot " << change.slot;
      EXPECT_EQ(change.was, !same(change.old_box, kNobody));
      EXPECT_EQ(change.is, !same(change.new_box, kNobody));
      known_[change.slot] = change.new_box;
    }
  }

  std::vector<Aabb> before_;  // the boxes at the last update
  std::vector<Slot> moved_;
  std::vector<Slot> removed_;
  std::vector<Slot> inserted_;
  std::vector<Aabb> known_;
};

TEST_P(FatBoxesTest, AreTheBoxesThemselvesUntilABodyMoves) {
  insert(uniform_boxes(50, 1));
  EXPECT_EQ(take(0), Extent::all);
  EXPECT_FALSE(fat_.have_slack());
  EXPECT_EQ(fat_.by_slot(boxes_), boxes_.data());
  insert({along_x(boxes_[0], 30)});
  remove(3);
  EXPECT_EQ(take(), Extent::listed);
  EXPECT_FALSE(fat_.have_slack());
  EXPECT_EQ(listed(), 2U);
  move(5, along_x(boxes_[5], 0.1F));
  EXPECT_EQ(take(), Extent::listed);
  EXPECT_TRUE(fat_.have_slack());
  EXPECT_EQ(listed(), 1U);
}

TEST_P(FatBoxesTest, OfThoseThatMoveReachAhead) {
  insert(uniform_boxes(50, 1));
  take(0);
  const Aabb before = boxes_[5];
  move(5, along_x(before, 0.05F));
  ASSERT_EQ(take(), Extent::listed);
  const FatBoxChange change = fat_.changes()[0];
  EXPECT_EQ(change.slot, 5U);
  EXPECT_TRUE(change.was && change.is);
  EXPECT_TRUE(same(change.old_box, before));
  EXPECT_TRUE(encloses(change.new_box, along_x(before, 0.2F)));
  for (int step = 2; step <= 4; ++step) {
    move(5, along_x(before, 0.05F * static_cast<float>(step)));
    EXPECT_EQ(take(), Extent::inside);
    EXPECT_EQ(listed(), 0U);
  }
  move(5, along_x(before, -1));
  EXPECT_EQ(take(), Extent::listed);
}

TEST_P(FatBoxesTest, OfABodyThatMovedToWhereItIsStaysTheSame) {
  insert(uniform_boxes(10, 1));
  take(0);
  move(5, boxes_[5]);
  EXPECT_EQ(take(), Extent::inside);
  EXPECT_TRUE(same(fat(5), boxes_[5]));
}

TEST_P(FatBoxesTest, AreListedForBodiesThatCameAndWent) {
  insert(uniform_boxes(10, 1));
  take(0);
  move(1, along_x(boxes_[1], 0.1F));
  take();
  const Aabb fat_before = fat(1);
  ASSERT_FALSE(same(fat_before, boxes_[1]));
  remove(1);
  remove(2);
  insert(10, {{50, 0, 0}, {51, 1, 1}});
  EXPECT_EQ(take(), Extent::listed);
  ASSERT_EQ(listed(), 3U);
  EXPECT_TRUE(same(fat_.changes()[0].old_box, fat_before)) << "it leaves the cells that its fat box was in";
  insert(1, {{60, 0, 0}, {61, 1, 1}});
  EXPECT_EQ(take(), Extent::listed);
  EXPECT_TRUE(same(fat(1), boxes_[1]));
}

TEST_P(FatBoxesTest, AreListedOneByOneUpToAsManyAsThereMayBe) {
  insert(uniform_boxes(40, 1));
  take(0);
  for (Slot slot = 0; slot < 5; ++slot) move(slot, along_x(boxes_[slot], 5));
  remove(10);
  insert({boxes_[0]});
  EXPECT_EQ(take(7), Extent::listed);
  EXPECT_EQ(listed(), 7U);
  for (Slot slot = 0; slot < 5; ++slot) move(slot, along_x(boxes_[slot], 5));
  remove(11);
  insert({boxes_[0]});
  EXPECT_EQ(take(6), Extent::all);
  EXPECT_EQ(listed(), 0U);
  for (Slot slot = 0; slot < 30; ++slot) {
    if (!std::isnan(boxes_[slot].min[0])) move(slot, along_x(boxes_[slot], 0.001F));
  }
  take(kAny);
}

TEST_P(FatBoxesTest, AreAllMadeAnewForThoseThatMoveWhenTooManyLeaveTheirs) {
  insert(uniform_boxes(60, 1));
  take(0);
  for (Slot slot = 0; slot < 60; ++slot) move(slot, along_x(boxes_[slot], 0.05F));
  EXPECT_EQ(take(10), Extent::all);
  EXPECT_TRUE(fat_.have_slack());
  for (int step = 0; step < 8; ++step) {
    for (Slot slot = 0; slot < 60; ++slot) move(slot, along_x(boxes_[slot], 0.049F));
    EXPECT_EQ(take(10), Extent::inside) << "step " << step;
  }
}

TEST_P(FatBoxesTest, DoNotAllEndAtOnce) {
  insert(std::vector<Aabb>(400, Aabb{{0, 0, 0}, {1, 1, 1}}));
  take(0);
  std::vector<std::size_t> changed;
  for (int step = 0; step < 30; ++step) {
    for (Slot slot = 0; slot < 400; ++slot) move(slot, along_x(boxes_[slot], 0.01F));
    changed.push_back(take() == Extent::inside ? 0 : listed());
  }
  EXPECT_EQ(changed[0], 400U);
  EXPECT_LT(*std::max_element(changed.begin() + 1, changed.end()), 200U);
}

// Their steps tell nothing of how far they stray: the smallest are much shorter than the longest.
TEST_P(FatBoxesTest, OfBodiesThatTrembleByChanceComeToLast) {
  contract::Random random(3);
  const std::vector<Aabb> places(200, Aabb{{0, 0, 0}, {1, 1, 1}});
  for (const double most : {1e-5, 1e-3, 0.05}) {
    fat_ = FatBoxes();
    boxes_.clear();
    insert(places);
    take(0);
    std::size_t changed = 0;
    for (int step = 0; step < 300; ++step) {
      for (Slot slot = 0; slot < 200; ++slot) {
        const double sway = most * std::pow(random.between(-1, 1), 3);
        move(slot, along_x(places[slot], static_cast<float>(sway)));
      }
      const bool any = take() != Extent::inside;
      changed += any && step >= 200 ? listed() : 0;
    }
    EXPECT_LT(changed, 100 * 200 / 10) << "a tenth of them at a time, where steps are up to " << most;
  }
}

// They sink, so little that a fat box made for a dozen of steps would have to be renewed all the time.
TEST_P(FatBoxesTest, OfBodiesThatCreepLast) {
  insert(std::vector<Aabb>(200, Aabb{{0, 0, 0}, {1, 1, 1}}));
  take(0);
  std::size_t changed = 0;
  for (int step = 0; step < 100; ++step) {
    for (Slot slot = 0; slot < 200; ++slot) move(slot, along_x(boxes_[slot], 1e-4F));
    changed += take() == Extent::inside ? 0 : listed();
  }
  EXPECT_LE(changed, 200U);
}

TEST_P(FatBoxesTest, ReachAsFarAsTheyAreToldAtLeast) {
  const Aabb unit = {{0, 0, 0}, {1, 1, 1}};
  insert(std::vector<Aabb>(8, unit));
  take(0);
  fat_.use_growth({.least = 0.25F, .most_halvings = 0});
  for (Slot slot = 0; slot < 8; ++slot) move(slot, along_x(unit, 1e-4F));
  take();
  for (Slot slot = 0; slot < 8; ++slot) EXPECT_EQ(fat(slot).max[0], boxes_[slot].max[0] + 0.25F) << slot;
  for (Slot slot = 0; slot < 8; ++slot) move(slot, along_x(unit, -1e-4F));
  take();
  for (Slot slot = 0; slot < 8; ++slot) {
    EXPECT_EQ(fat(slot).min[0], boxes_[slot].min[0] - 0.125F) << slot;
    EXPECT_EQ(fat(slot).max[1], 1.125F) << "to either side, as it turned: " << slot;
  }
}

TEST_P(FatBoxesTest, OfBodiesThatTrembleReachAsFarAsTheyAreToldFromThenOn) {
  const Aabb unit = {{0, 0, 0}, {1, 1, 1}};
  insert(std::vector<Aabb>(8, unit));
  take(0);
  for (const float by : {1e-4F, -1e-4F}) {
    for (Slot slot = 0; slot < 8; ++slot) move(slot, along_x(unit, by));
    take();
  }
  EXPECT_EQ(fat(0).max[1], 1 + 1.0F / 64);
  fat_.use_growth({.updates = 0, .most_halvings = 1, .raise = 0});
  for (Slot slot = 0; slot < 8; ++slot) move(slot, along_x(unit, 0.05F));
  take();
  for (Slot slot = 0; slot < 8; ++slot) EXPECT_EQ(fat(slot).max[1], 1 + 1.0F / 16) << slot;
  fat_.use_growth({.updates = 0, .most_halvings = 1, .raise = 1});
  for (Slot slot = 0; slot < 8; ++slot) move(slot, along_x(unit, -0.05F));
  take();
  for (Slot slot = 0; slot < 8; ++slot) EXPECT_EQ(fat(slot).max[1], 1 + 1.0F / 8) << "at once: " << slot;
}

TEST_P(FatBoxesTest, AreBeingLeftByBodiesOnTheirWayNotByThoseThatCreep) {
  insert(std::vector<Aabb>(200, Aabb{{0, 0, 0}, {1, 1, 1}}));
  take(0);
  for (const auto& [step, leave] : {std::pair(1e-4F, false), std::pair(0.05F, true)}) {
    for (int update = 0; update < 2; ++update) {
      for (Slot slot = 0; slot < 200; ++slot) move(slot, along_x(boxes_[slot], step));
      if (update == 0) refit();
    }
    EXPECT_EQ(fat_.are_being_left(changes(), 8), leave) << step;
    take();
  }
}

// What lasted while they trembled much is too large for what they do now.
TEST_P(FatBoxesTest, OfBodiesThatCameToRestAreSmallerOnceMadeAnew) {
  insert(std::vector<Aabb>(20, Aabb{{0, 0, 0}, {1, 1, 1}}));
  take(0);
  const auto tremble = [&](int step, float most) {
    for (Slot slot = 0; slot < 20; ++slot) move(slot, along_x(boxes_[slot], step % 2 == 0 ? most : -most));
  };
  for (int step = 0; step < 40; ++step) {
    tremble(step, 0.08F);
    take();
  }
  for (int step = 0; step < 10; ++step) {
    tremble(step, 1e-5F);
    EXPECT_EQ(take(), Extent::inside);
  }
  EXPECT_GT(fat(0).max[1], 1.05F);
  tremble(0, 1e-5F);
  refit();
  EXPECT_LE(fat(0).max[1], 1.02F);
  std::size_t changed = 0;
  for (int step = 1; step < 100; ++step) {
    tremble(step, 1e-5F);
    changed += take() == Extent::inside ? 0 : listed();
  }
  EXPECT_LE(changed, 3 * 20U) << "and last soon";
}

TEST_P(FatBoxesTest, OfABodyThatTrembledAndWentItsWayAreAsThoseOfOthers) {
  insert({{{0, 0, 0}, {1, 1, 1}}});
  take(0);
  for (int step = 0; step < 40; ++step) {
    move(0, along_x(boxes_[0], step % 2 == 0 ? 0.01F : -0.01F));
    take();
  }
  EXPECT_LT(fat(0).min[1], boxes_[0].min[1]) << "it may go to any side";
  for (int step = 0; step < 200; ++step) {
    move(0, along_x(boxes_[0], 0.01F));
    take();
  }
  EXPECT_EQ(fat(0).min[1], boxes_[0].min[1]);
}

TEST_P(FatBoxesTest, MayBePreparedForLaterAPartAtATime) {
  insert(uniform_boxes(60, 1));
  take(0);
  const auto go_on = [&] {
    for (Slot slot = 0; slot < 60; ++slot) move(slot, along_x(boxes_[slot], slot == 7 ? 0 : 0.01F));
  };
  go_on();
  take(0);
  fat_.begin_prepared(boxes_);
  for (std::size_t part = 0; part < 3; ++part) {
    go_on();
    std::vector<Slot> moved(60);
    std::iota(moved.begin(), moved.end(), 0);
    std::vector<Aabb> before = boxes_;
    for (Slot slot = 0; slot < 60; ++slot) before[slot] = along_x(boxes_[slot], slot == 7 ? 0 : -0.01F);
    ASSERT_EQ(take(), Extent::inside);
    const auto ahead = static_cast<float>(3 - part);
    fat_.prepare(crew_, {boxes_, {before}, {}, moved, {}, 60}, {20 * part, 20 * part + 20}, ahead, 5);
  }
  const std::vector<Aabb> prepared(fat_.prepared().begin(), fat_.prepared().end());
  for (int update = 0; update < 5; ++update) {
    go_on();
    for (Slot slot = 0; slot < 60; ++slot)
      ASSERT_TRUE(encloses(prepared[slot], boxes_[slot])) << "slot " << slot << ", update " << update;
  }
  fat_.use_prepared();
  EXPECT_TRUE(same(fat_.by_slot(boxes_)[3], prepared[3]));
}

// Each tenth body turns after its own was made, each twentieth comes to rest and one leaps.
TEST_P(FatBoxesTest, ThatArePreparedAreMadeAnewWhereBodiesWillNotBeInThem) {
  constexpr Slot kBodies = 200, kLeaps = 3;
  insert(uniform_boxes(kBodies, 2));
  take(0);
  std::vector<float> steps(kBodies, 0.02F);
  std::vector<Slot> moved(kBodies);
  std::iota(moved.begin(), moved.end(), Slot{0});
  std::vector<Aabb> before;
  const auto go_on = [&] {
    before = boxes_;
    for (Slot slot = 0; slot < kBodies; ++slot) move(slot, along_x(boxes_[slot], steps[slot]));
  };
  const auto changes = [&] { return BodyChanges{boxes_, {before}, {}, moved, {}, kBodies}; };
  go_on();
  take(0);
  fat_.begin_prepared(boxes_);
  go_on();
  fat_.prepare(crew_, changes(), {0, kBodies}, 4, 5);
  take();
  std::set<Slot> expected;
  for (Slot slot = 0; slot < kBodies; slot += 10) {
    steps[slot] = slot % 20 == 0 ? 0 : -0.02F;
    expected.insert(slot);
  }
  steps[kLeaps] = 9;
  go_on();
  steps[kLeaps] = 0.02F;
  const std::vector<Aabb> prepared(fat_.prepared().begin(), fat_.prepared().end());
  std::set<Slot> listed;
  for (const Share places : {Share{0, 60}, Share{60, 60}, Share{60, kBodies}}) {
    for (const FatBoxChange& change : fat_.mend_prepared(crew_, changes(), places, 3, 5)) {
      EXPECT_TRUE(listed.insert(change.slot).second);
      EXPECT_TRUE(change.was && change.is && places.first <= change.slot && change.slot < places.last);
      EXPECT_TRUE(same(change.old_box, prepared[change.slot]));
      EXPECT_TRUE(same(change.new_box, fat_.prepared()[change.slot]));
    }
  }
  EXPECT_EQ(listed, expected) << "where one that leaps will be nobody knows";
  take();
  for (int update = 0; update < 2; ++update) go_on();
  for (int update = 0; update < 5; ++update) {
    go_on();
    for (Slot slot = 0; slot < kBodies; ++slot) {
      if (slot == kLeaps) continue;
      ASSERT_TRUE(encloses(fat_.prepared()[slot], boxes_[slot])) << "slot " << slot << ", update " << update;
    }
  }
}

// One that trembles keeps the fat box that it has, also where that is another one than when others were made.
TEST_P(FatBoxesTest, ThatArePreparedAreThoseThatTrembleHaveNow) {
  constexpr Slot kBodies = 20;
  insert(uniform_boxes(kBodies, 3));
  take(0);
  const std::vector<Aabb> first = boxes_;
  std::vector<Slot> moved(kBodies);
  std::iota(moved.begin(), moved.end(), Slot{0});
  std::vector<Aabb> before;
  const auto tremble = [&](float by) {
    before = boxes_;
    for (Slot slot = 0; slot < kBodies; ++slot) move(slot, along_x(first[slot], by));
  };
  const auto changes = [&] { return BodyChanges{boxes_, {before}, {}, moved, {}, kBodies}; };
  for (int update = 0; update < 12; ++update) {
    tremble(update % 2 == 0 ? 0.001F : 0);
    take();
  }
  fat_.begin_prepared(boxes_);
  tremble(0.001F);
  fat_.prepare(crew_, changes(), {0, kBodies}, 3, 5);
  take();
  tremble(0.02F);
  take();
  ASSERT_GT(listed(), 0U);
  tremble(0.019F);
  take();
  std::set<Slot> left;
  for (Slot slot = 0; slot < kBodies; ++slot) {
    if (!encloses(fat_.prepared()[slot], boxes_[slot])) left.insert(slot);
  }
  ASSERT_FALSE(left.empty());
  for (const FatBoxChange& change : fat_.mend_prepared(crew_, changes(), {0, kBodies}, 1, 5)) {
    EXPECT_EQ(left.erase(change.slot), 1U);
    EXPECT_TRUE(same(change.new_box, fat(change.slot)));
  }
  EXPECT_THAT(left, IsEmpty());
}

TEST_P(FatBoxesTest, AreTheBoxesAgainWhenSlackIsDropped) {
  insert(uniform_boxes(500, 1));
  take(0);
  for (Slot slot = 0; slot < 500; ++slot) move(slot, along_x(boxes_[slot], 0.05F));
  take(0);
  ASSERT_TRUE(fat_.have_slack());
  const std::size_t bytes = fat_.bytes();
  fat_.drop_slack();
  EXPECT_FALSE(fat_.have_slack());
  EXPECT_EQ(fat_.by_slot(boxes_), boxes_.data());
  EXPECT_LE(fat_.bytes() + 500 * sizeof(Aabb), bytes) << "their memory is given back";
}

TEST_P(FatBoxesTest, OfFewAmongManyTakeLittleMemory) {
  constexpr std::size_t kBodies = 10'000;
  insert(uniform_boxes(kBodies, 1));
  take(0);
  const std::size_t bytes = fat_.bytes();
  for (const Slot slot : {Slot{7}, Slot{5000}, Slot{kBodies - 1}}) move(slot, along_x(boxes_[slot], 0.05F));
  remove(8);
  remove(300);
  EXPECT_EQ(take(), Extent::listed);
  EXPECT_EQ(listed(), 5U);
  EXPECT_LE(fat_.bytes() - bytes, kBodies * sizeof(Aabb) / 8);
  const Aabb* const all = fat_.by_slot(boxes_);
  for (Slot slot = 0; slot < kBodies; ++slot) ASSERT_TRUE(same(all[slot], fat(slot))) << slot;
  EXPECT_GE(fat_.bytes(), kBodies * sizeof(Aabb));
  move(7, along_x(boxes_[7], 0.05F));
  insert(8, boxes_[9]);
  EXPECT_EQ(take(), Extent::listed);
}

TEST_P(FatBoxesTest, OfFewAreThoseOfManyOnceManyMove) {
  insert(uniform_boxes(2000, 1));
  take(0);
  move(1000, along_x(boxes_[1000], 0.05F));
  take();
  const Aabb before = fat(1000);
  for (Slot slot = 0; slot < 800; ++slot) move(slot, along_x(boxes_[slot], 0.05F));
  EXPECT_EQ(take(), Extent::listed);
  EXPECT_EQ(listed(), 800U);
  EXPECT_TRUE(same(fat(1000), before));
}

/// What happens at random.
struct RandomChanges {
  std::size_t slots = 0;
  std::size_t many = 0;  ///< changes at most in one of ten updates, in others a dozen
  std::size_t few = 0;   ///< may be listed in one of four updates, in others all
};

class FatBoxesAtRandom : public FatBoxesTest {
 protected:
  void expect_enclosed(const RandomChanges& changes);
};

void FatBoxesAtRandom::expect_enclosed(const RandomChanges& changes) {
  const auto& [slots, many, few] = changes;
  contract::Random random(1);
  insert(uniform_boxes(slots, 2));
  take(0);
  for (int step = 0; step < 300; ++step) {
    std::set<Slot> changed;
    for (std::size_t i = random.below(step % 10 == 0 ? many : 12); i > 0; --i) {
      const auto slot = static_cast<Slot>(random.below(boxes_.size() + 2));
      if (!changed.insert(slot).second) continue;
      if (slot >= boxes_.size() || std::isnan(boxes_[slot].min[0])) {
        insert(slot, cube_in(random, 1, 20));
      } else if (random.one_in(6)) {
        remove(slot);
      } else {
        move(slot,
             random.one_in(8) ? cube_in(random, 1, 20) : along_x(boxes_[slot], random.between(-0.2F, 0.2F)));
      }
    }
    if (changed.empty()) continue;
    const std::size_t most = random.one_in(4) ? few : kAny;
    const Extent extent = take(most);
    EXPECT_TRUE(extent != Extent::listed || listed() <= most);
    if (HasFailure()) return;
  }
}

TEST_P(FatBoxesAtRandom, EncloseBoxesThroughAnyChanges) {
  expect_enclosed({.slots = 200, .many = 150, .few = 3});
}

TEST_P(FatBoxesAtRandom, EncloseBoxesThroughChangesOfFewAmongMany) {
  expect_enclosed({.slots = 3000, .many = 12, .few = kAny});
}

TEST_P(FatBoxesAtRandom, EncloseBoxesThroughChangesOfFewAmongManyThatMayNotBeListed) {
  expect_enclosed({.slots = 3000, .many = 12, .few = 3});
}

INSTANTIATE_TEST_SUITE_P(Workers, FatBoxesTest, numbers_of_workers());
INSTANTIATE_TEST_SUITE_P(Workers, FatBoxesAtRandom, numbers_of_workers());

}  // namespace
}  // namespace cellsweep::stream
