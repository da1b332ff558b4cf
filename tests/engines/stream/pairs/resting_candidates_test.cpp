/// @file
/// Candidates of bodies that rest are parted from the others, and come back in their places.
#include "engines/stream/pairs/resting_candidates.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "cellsweep/engine/engine.h"
#include "contract/random.h"

namespace cellsweep::stream {
namespace {

constexpr Slot kSlots = 200;

/// Each body has candidates with some others, of which every third overlaps.
class RestingCandidatesTest : public testing::Test {
 protected:
  RestingCandidatesTest() {
    contract::Random random(3);
    for (Slot one = 0; one < kSlots; ++one) {
      for (Slot other = one + 1; other < kSlots; ++other) {
        if (random.one_in(20)) listed_.push_back({one, other});
      }
    }
    pairs_.renew(listed_.size());
    marks_.renew(listed_.size());
    std::ranges::copy(listed_, pairs_.data());
    for (std::size_t i = 0; i < listed_.size(); ++i) marks_.data()[i] = mark_of(listed_[i]);
  }

  static std::uint8_t mark_of(const SlotPair& pair) { return (pair.a + pair.b) % 3 == 0 ? 1 : 0; }

  bool update(std::span<const Slot> moved, std::span<const Slot> removed = {}) {
    return resting_.begin_update({boxes_, {}, removed, moved, {}, kSlots});
  }
  void update_until_known(std::span<const Slot> moved) {
    for (int update = 0; update < 2000 && !resting_.are_known(); ++update) this->update(moved);
  }
  void part() { resting_.part({pairs_, marks_}); }
  void reunite() { resting_.reunite({pairs_, marks_}); }

  std::vector<SlotPair> pairs() const { return {pairs_.data(), pairs_.data() + pairs_.size()}; }
  void expect_marks() const {
    ASSERT_EQ(marks_.size(), pairs_.size());
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      EXPECT_EQ(marks_.data()[i], mark_of(pairs_.data()[i])) << i;
  }

  std::vector<Aabb> boxes_{kSlots};
  std::vector<SlotPair> listed_;
  Array<SlotPair> pairs_;
  Array<std::uint8_t> marks_;
  RestingCandidates resting_;
};

TEST_F(RestingCandidatesTest, AreThoseOfTwoThatDidNotMove) {
  const std::vector<Slot> moved = {3, 50, 51, 199};
  update_until_known(moved);
  part();
  ASSERT_TRUE(resting_.are_parted());
  std::vector<SlotPair> expected;
  for (const SlotPair& pair : listed_) {
    if (std::ranges::count(moved, pair.a) + std::ranges::count(moved, pair.b) > 0) expected.push_back(pair);
  }
  EXPECT_THAT(pairs(), testing::ElementsAreArray(expected));
  EXPECT_EQ(resting_.size(), listed_.size() - expected.size());
  expect_marks();
  EXPECT_FALSE(update(moved));
  reunite();
  EXPECT_THAT(pairs(), testing::ElementsAreArray(listed_));
  EXPECT_EQ(resting_.size(), 0U);
  expect_marks();
}

TEST_F(RestingCandidatesTest, ComeBackAmongCandidatesThatChangedMeanwhile) {
  update_until_known({{7}});
  part();
  const std::vector<SlotPair> others = {{1, 7}, {7, 9}, {7, 150}, {7, 199}};
  pairs_.renew(others.size());
  marks_.renew(others.size());
  std::ranges::copy(others, pairs_.data());
  for (std::size_t i = 0; i < others.size(); ++i) marks_.data()[i] = mark_of(others[i]);
  reunite();
  std::vector<SlotPair> expected = others;
  for (const SlotPair& pair : listed_) {
    if (pair.a != 7 && pair.b != 7) expected.push_back(pair);
  }
  std::ranges::sort(expected);
  EXPECT_THAT(pairs(), testing::ElementsAreArray(expected));
  expect_marks();
}

TEST_F(RestingCandidatesTest, AreAllOrNoneToo) {
  update_until_known({});
  part();
  EXPECT_TRUE(pairs().empty());
  reunite();
  EXPECT_THAT(pairs(), testing::ElementsAreArray(listed_));
  pairs_.shrink(0);
  marks_.shrink(0);
  update_until_known({{4}});
  part();
  reunite();
  EXPECT_TRUE(pairs().empty());
}

TEST_F(RestingCandidatesTest, AreToBeReunitedWhenOneMovesOrGoes) {
  for (const bool goes : {false, true}) {
    update_until_known({{3, 4}});
    part();
    ASSERT_TRUE(resting_.are_parted());
    EXPECT_FALSE(update({{4}}));
    const std::vector<Slot> one = {9};
    EXPECT_TRUE(goes ? update({}, one) : update(one));
    reunite();
  }
}

TEST_F(RestingCandidatesTest, AreNotPartedWhereMostBodiesMove) {
  std::vector<Slot> moved;
  for (Slot slot = 0; slot < kSlots; slot += 2) moved.push_back(slot);
  update_until_known(moved);
  part();
  EXPECT_FALSE(resting_.are_parted());
  EXPECT_THAT(pairs(), testing::ElementsAreArray(listed_));
  EXPECT_FALSE(resting_.are_known()) << "it is looked again later";
}

// Others move each time, or one begins to as soon as they are parted: then that is tried ever less often.
TEST_F(RestingCandidatesTest, AreSeldomPartedWhereThatDoesNotLast) {
  int parted = 0;
  for (Slot update = 0; update < 2000; ++update) {
    const std::vector<Slot> moved = {update % kSlots, (update + 1) % kSlots};
    if (this->update(moved)) reunite();
    if (!resting_.are_known()) continue;
    part();
    parted += resting_.are_parted() ? 1 : 0;
  }
  EXPECT_LE(parted, 1);
  Slot moving = 0;
  for (int update = 0; update < 2000; ++update) {
    if (resting_.are_parted()) moving = (moving + 1) % kSlots;
    if (this->update({{moving}})) reunite();
    if (!resting_.are_known()) continue;
    part();
    parted += resting_.are_parted() ? 1 : 0;
  }
  EXPECT_LT(parted, 25);
}

}  // namespace
}  // namespace cellsweep::stream
