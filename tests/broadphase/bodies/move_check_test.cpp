/// @file
/// What a worker finds out about its share of a move(): bodies in runs or anywhere, at rest or not.
#include "broadphase/bodies/move_check.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

#include "contract/random.h"

namespace cellsweep {
namespace {

using Ids = std::vector<BodyId>;

bool same(const Aabb& one, const Aabb& other) {
  return std::memcmp(&one, &other, sizeof(Aabb)) == 0;
}

Aabb box_at(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

/// Bodies with boxes of their own, each at rest.
class MoveCheckTest : public testing::Test {
 protected:
  void hold(const Ids& ids) {
    Vector<Slot> slots;
    ASSERT_TRUE(table_.insert(ids, slots));
    boxes_.resize(table_.slot_count(), kNobody);
    states_.resize(table_.slot_count(), kGone);
    for (const Slot slot : slots) {
      boxes_[slot] = box_of(slot);
      states_[slot] = kAtRest;
    }
  }
  void hold_first(std::size_t count) {
    Ids ids(count);
    std::iota(ids.begin(), ids.end(), BodyId{0});
    hold(ids);
  }
  void remove(BodyId id) {
    const Slot slot = table_.find(id);
    table_.reserve_removals(1);
    table_.remove(slot);
    states_[slot] = kGone;
  }

  static Aabb box_of(Slot slot) { return box_at(10.0F + static_cast<float>(slot)); }

  /// The boxes that these bodies have.
  std::vector<Aabb> boxes_of(const Ids& ids) const {
    std::vector<Aabb> boxes;
    for (const BodyId id : ids) boxes.push_back(boxes_[table_.find(id)]);
    return boxes;
  }

  /// All of the call, as one share. What is listed is `moved_`.
  void run(const Ids& ids, const std::vector<Aabb>& boxes, Unmoved unmoved = Unmoved::left_out) {
    run(ids, boxes, {0, ids.size()}, unmoved);
  }
  void run(const Ids& ids, const std::vector<Aabb>& boxes, Share share, Unmoved unmoved = Unmoved::left_out) {
    moved_.assign(share.last - share.first, {kNobody, 999});
    check_.run({table_, boxes_.data(), states_.data()}, ids, boxes, share, moved_.data(), unmoved);
    if (check_.good()) moved_.resize(check_.moved());
  }

  /// The boxes of the call by slot, as far as they are listed; of several for one body the last.
  std::map<Slot, Aabb> listed() const {
    std::map<Slot, Aabb> all;
    for (const ChangedBody& body : moved_) all.insert_or_assign(body.slot, body.before);
    return all;
  }

  IdTable table_;
  std::vector<Aabb> boxes_;
  std::vector<BodyState> states_;
  MoveCheck check_;
  std::vector<ChangedBody> moved_;
};

TEST_F(MoveCheckTest, OfNobodyIsGood) {
  hold_first(3);
  run({}, {});
  EXPECT_TRUE(check_.good());
  EXPECT_TRUE(check_.ascends());
  EXPECT_EQ(check_.moved(), 0U);
}

TEST_F(MoveCheckTest, ListsNobodyOfThoseThatStayWhereTheyAre) {
  hold_first(100);
  Ids ids(100);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  run(ids, boxes_of(ids));
  EXPECT_TRUE(check_.good());
  EXPECT_TRUE(check_.ascends());
  EXPECT_EQ(check_.moved(), 0U);
  EXPECT_EQ(check_.first(), 0U);
  EXPECT_EQ(check_.last(), 99U);
}

TEST_F(MoveCheckTest, ListsThoseThatStayWhenItIsToldTo) {
  hold_first(100);
  Ids ids(100);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  run(ids, boxes_of(ids), Unmoved::kept);
  ASSERT_EQ(check_.moved(), 100U);
  for (Slot slot = 0; slot < 100; ++slot) {
    EXPECT_EQ(moved_[slot].slot, slot);
    EXPECT_TRUE(same(moved_[slot].before, box_of(slot)));
  }
}

TEST_F(MoveCheckTest, ListsEveryBodyThatMovesWhereverItStands) {
  hold_first(100);
  Ids ids(100);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  for (std::size_t mover = 0; mover < 100; ++mover) {
    std::vector<Aabb> boxes = boxes_of(ids);
    boxes[mover] = box_at(-5);
    run(ids, boxes);
    ASSERT_TRUE(check_.good());
    const auto all = listed();
    ASSERT_TRUE(all.contains(static_cast<Slot>(mover))) << mover;
    for (const auto& [slot, box] : all)
      EXPECT_TRUE(same(box, boxes[slot])) << "a body may be listed that stays";
  }
}

TEST_F(MoveCheckTest, ListsABodyThatHasMovedAlreadyAndIsToldToStay) {
  hold_first(100);
  states_[50] = 7;
  states_[70] = kInserted;
  Ids ids(100);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  run(ids, boxes_of(ids));
  EXPECT_TRUE(listed().contains(50));
  EXPECT_TRUE(listed().contains(70));
  run({50}, {box_of(50)});
  EXPECT_EQ(check_.moved(), 1U);
}

TEST_F(MoveCheckTest, ListsBoxesMadeCanonical) {
  constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
  hold_first(40);
  for (const std::size_t place : {0, 1, 31, 32, 39}) {
    Ids ids(40);
    std::iota(ids.begin(), ids.end(), BodyId{0});
    std::vector<Aabb> boxes = boxes_of(ids);
    boxes[place] = {{-0.0F, kDenormal, -1}, {kDenormal, 1, -0.0F}};
    run(ids, boxes);
    ASSERT_TRUE(check_.good());
    EXPECT_TRUE(same(listed().at(static_cast<Slot>(place)), {{0, 0, -1}, {0, 1, 0}})) << place;
  }
}

TEST_F(MoveCheckTest, ABoxThatIsTheSameWhenItIsCanonicalMovesNobody) {
  hold_first(1);
  boxes_[0] = Aabb{};
  run({0}, {{{-0.0F, 0, 0}, {0, 0, std::numeric_limits<float>::denorm_min()}}});
  EXPECT_TRUE(check_.good());
  EXPECT_EQ(check_.moved(), 0U);
}

TEST_F(MoveCheckTest, IsNotGoodWithAnInvalidBoxOrAnUnknownBodyWhereverItStands) {
  hold_first(100);
  Ids ids(100);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  for (const Unmoved unmoved : {Unmoved::left_out, Unmoved::kept}) {
    for (const float shift : {0.0F, 1.0F}) {
      std::vector<Aabb> boxes = boxes_of(ids);
      for (Aabb& box : boxes) box.min[1] -= shift;
      for (std::size_t bad = 0; bad < 100; ++bad) {
        std::vector<Aabb> bad_boxes = boxes;
        bad_boxes[bad].max[bad % 3] = bad % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : -1e9F;
        run(ids, bad_boxes, unmoved);
        EXPECT_FALSE(check_.good()) << bad;
        Ids bad_ids = ids;
        bad_ids[bad] = bad % 2 == 0 ? 100 : 0xffffffff;
        run(bad_ids, boxes, unmoved);
        EXPECT_FALSE(check_.good()) << bad;
      }
    }
  }
}

TEST_F(MoveCheckTest, DoesNotTakeARemovedBodyForOneOfARun) {
  for (const BodyId gone : {0U, 40U, 99U}) {
    table_ = {};
    boxes_.clear();
    states_.clear();
    hold_first(100);
    Ids ids(100);
    std::iota(ids.begin(), ids.end(), BodyId{0});
    const std::vector<Aabb> boxes = boxes_of(ids);
    remove(gone);
    run(ids, boxes);
    EXPECT_FALSE(check_.good()) << gone;
    hold({gone});
    run(ids, boxes, Unmoved::kept);
    ASSERT_TRUE(check_.good()) << gone << " came back in another slot";
    EXPECT_TRUE(same(listed().at(100), boxes[gone]));
    EXPECT_EQ(check_.ascends(), gone == 99);
  }
}

TEST_F(MoveCheckTest, SaysWhetherSlotsAscend) {
  hold({5, 1'000'000, 7, 2, 0xffffffff, 3});
  const auto ascends = [&](const Ids& ids) {
    run(ids, boxes_of(ids));
    EXPECT_TRUE(check_.good());
    EXPECT_EQ(check_.first(), table_.find(ids.front()));
    EXPECT_EQ(check_.last(), table_.find(ids.back()));
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
  hold_first(200);
  Ids ids(150);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  for (const std::size_t place : {1, 31, 32, 33, 64, 149}) {
    Ids twice = ids;
    twice[place] = 0;
    run(twice, boxes_of(twice));
    EXPECT_FALSE(check_.ascends()) << place;
  }
}

TEST_F(MoveCheckTest, LooksAtItsShareAlone) {
  hold_first(100);
  Ids ids(100);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  ids[10] = 5000;
  ids[90] = 5000;
  std::vector<Aabb> boxes(100, box_at(-9));
  boxes[91] = kNobody;
  run(ids, boxes, {20, 85});
  ASSERT_TRUE(check_.good());
  EXPECT_EQ(check_.first(), 20U);
  EXPECT_EQ(check_.last(), 84U);
  ASSERT_EQ(check_.moved(), 65U);
  for (Slot i = 0; i < 65; ++i) EXPECT_EQ(moved_[i].slot, 20 + i);
  run(ids, boxes, {50, 50});
  EXPECT_TRUE(check_.good());
  EXPECT_EQ(check_.moved(), 0U);
}

TEST_F(MoveCheckTest, ListsTheLastBoxOfEveryBodyOfRandomCalls) {
  contract::Random random(1);
  Ids held(70);
  std::iota(held.begin(), held.end(), BodyId{0});
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
    std::vector<Aabb> boxes = boxes_of(ids);
    for (Aabb& box : boxes) {
      if (random.one_in(3)) box = box_at(static_cast<float>(random.whole(-3, 3)));
    }
    run(ids, boxes, Unmoved::kept);
    ASSERT_TRUE(check_.good());
    ASSERT_EQ(check_.moved(), ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      ASSERT_EQ(moved_[i].slot, table_.find(ids[i]));
      ASSERT_TRUE(same(moved_[i].before, boxes[i]));
    }
    std::vector<Slot> slots;
    for (const BodyId id : ids) slots.push_back(table_.find(id));
    ASSERT_EQ(check_.ascends(), std::ranges::adjacent_find(slots, std::greater_equal<>()) == slots.end());
  }
}

}  // namespace
}  // namespace cellsweep
