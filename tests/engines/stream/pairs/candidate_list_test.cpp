/// @file
/// The candidates of engine `stream`: found anew or changed one by one, always ascending.
#include "engines/stream/pairs/candidate_list.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/threads/numbers_of_workers.h"
#include "base/threads/thread_pool.h"
#include "base/tuning.h"
#include "contract/effort.h"
#include "contract/random.h"

namespace cellsweep::stream {
namespace {

using contract::Random;
using testing::ElementsAre;
using testing::IsEmpty;

/// Keys in several parts, as workers leave them.
class Parts {
 public:
  explicit Parts(std::size_t count) : keys_(count) {}
  Parts(std::initializer_list<SlotPair> pairs) : keys_(1) {
    for (const SlotPair& pair : pairs) add(0, pair);
  }

  void add(std::size_t part, SlotPair pair) { keys_[part % keys_.size()].push_back(pair_key(pair)); }

  KeyParts view() {
    views_.assign(keys_.begin(), keys_.end());
    return views_;
  }

 private:
  std::vector<std::vector<std::uint64_t>> keys_;
  std::vector<std::span<const std::uint64_t>> views_;
};

class CandidateListTest : public testing::TestWithParam<unsigned> {
 protected:
  static constexpr std::size_t kSlots = 1000;

  /// Says of these bodies that they changed.
  const std::uint8_t* changed(const std::vector<Slot>& slots) {
    changed_.assign(kSlots, 0);
    for (const Slot slot : slots) changed_[slot] = 1;
    return changed_.data();
  }
  bool touches(const SlotPair& pair) const { return (changed_[pair.a] | changed_[pair.b]) != 0; }

  std::vector<std::uint8_t> changed_;
  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
  CandidateList list_;
  PairRoom room_;
  Array<SlotPair> spare_;
};

TEST_P(CandidateListTest, IsEmptyAtFirst) {
  EXPECT_EQ(list_.size(), 0U);
  EXPECT_THAT(list_.pairs(crew_, room_), IsEmpty());
}

TEST_P(CandidateListTest, IsAscendingInWhicheverOrderPairsWereFound) {
  Parts found(3);
  found.add(0, {3, 4});
  found.add(2, {1, 9});
  found.add(0, {0, 2});
  found.add(2, {1, 2});
  list_.replace(found.view());
  EXPECT_EQ(list_.size(), 4U) << "before they are sorted";
  EXPECT_THAT(list_.pairs(crew_, room_),
              ElementsAre(SlotPair{0, 2}, SlotPair{1, 2}, SlotPair{1, 9}, SlotPair{3, 4}));
  EXPECT_EQ(list_.size(), 4U);
}

/// So many pairs of as many bodies and some more, no two the same, the last ones first.
Parts many_pairs(Slot count) {
  Parts found(2);
  for (Slot i = count; i-- > 0;) found.add(i % 2, {i, i + 1 + i % 5});
  return found;
}

TEST_P(CandidateListTest, IsSortedAPartAtATime) {
  constexpr Slot kFew = 100, kMany = 100'000;
  for (const Slot count : {kFew, kMany}) {
    std::vector<SlotPair> ascending;
    for (Slot i = 0; i < count; ++i) ascending.push_back({i, i + 1 + i % 5});
    Parts found = many_pairs(count);
    for (const int parts : {1, 3, 7}) {
      list_.replace(found.view());
      list_.begin_sort(crew_, spare_);
      EXPECT_EQ(list_.sort_until(crew_, 0), count == kFew);
      for (int part = 1; part < parts; ++part)
        EXPECT_EQ(list_.sort_until(crew_, 1.0 * part / parts), count == kFew) << part;
      EXPECT_TRUE(list_.sort_until(crew_, 1));
      EXPECT_EQ(list_.size(), count);
      ASSERT_TRUE(std::ranges::equal(list_.pairs(crew_, room_), ascending));
    }
  }
}

TEST_P(CandidateListTest, IsWholeWhoeverAsksBeforeAllPartsAreSorted) {
  constexpr Slot kMany = 100'000;
  Parts found = many_pairs(kMany);
  for (const double share : {0.0, 0.3}) {
    list_.replace(found.view());
    list_.begin_sort(crew_, spare_);
    list_.sort_until(crew_, share);
    EXPECT_EQ(list_.pairs(crew_, room_).size(), kMany);
    EXPECT_TRUE(std::ranges::is_sorted(list_.pairs(crew_, room_), {},
                                       [](const SlotPair& pair) { return pair_key(pair); }));
  }
  list_.replace(found.view());
  list_.begin_sort(crew_, spare_);
  Parts few{{1, 2}, {0, 3}};
  list_.replace(few.view());
  EXPECT_THAT(list_.pairs(crew_, room_), ElementsAre(SlotPair{0, 3}, SlotPair{1, 2}));
}

TEST_P(CandidateListTest, IsReplacedByWhatIsFoundAnew) {
  Parts first{{1, 2}, {3, 4}};
  list_.replace(first.view());
  Parts second{{3, 4}, {0, 9}};
  list_.take(crew_, room_, spare_);
  EXPECT_THAT(spare_.view(), ElementsAre(SlotPair{1, 2}, SlotPair{3, 4}));
  EXPECT_EQ(list_.size(), 0U);
  list_.replace(second.view());
  EXPECT_THAT(list_.found(), testing::SizeIs(1));
  EXPECT_THAT(list_.pairs(crew_, room_), ElementsAre(SlotPair{0, 9}, SlotPair{3, 4}));
  Parts none(2);
  list_.replace(none.view());
  EXPECT_EQ(list_.size(), 0U);
  EXPECT_THAT(list_.pairs(crew_, room_), IsEmpty());
}

TEST_P(CandidateListTest, SaysWhatBeganAndEndedInOrder) {
  Parts found{{3, 4}, {1, 2}, {2, 5}};
  list_.replace(found.view());
  Parts touched{{5, 6}, {0, 1}};
  const SlotPairChanges changes = list_.change(crew_, room_, touched.view(), changed({0, 1, 3, 6}));
  EXPECT_THAT(changes.began, ElementsAre(SlotPair{0, 1}, SlotPair{5, 6}));
  EXPECT_THAT(changes.ended, ElementsAre(SlotPair{1, 2}, SlotPair{3, 4}));
  EXPECT_THAT(list_.pairs(crew_, room_), ElementsAre(SlotPair{0, 1}, SlotPair{2, 5}, SlotPair{5, 6}));
}

TEST_P(CandidateListTest, APairOfBodiesThatChangedMayStay) {
  Parts found{{1, 2}, {4, 5}};
  list_.replace(found.view());
  Parts touched{{1, 2}, {0, 9}};
  const SlotPairChanges changes = list_.change(crew_, room_, touched.view(), changed({1, 4, 9}));
  EXPECT_THAT(changes.began, ElementsAre(SlotPair{0, 9}));
  EXPECT_THAT(changes.ended, ElementsAre(SlotPair{4, 5}));
  EXPECT_THAT(list_.pairs(crew_, room_), ElementsAre(SlotPair{0, 9}, SlotPair{1, 2}));
}

TEST_P(CandidateListTest, OfSeveralNotesOnAPairTheLastCounts) {
  Parts found{{1, 2}, {4, 5}};
  list_.replace(found.view());
  const std::uint64_t one = pair_key(SlotPair{4, 5});
  const std::uint64_t other = pair_key(SlotPair{7, 8});
  list_.begin_notes(crew_, room_);
  EXPECT_TRUE(list_.note({&one, 1}, false));
  EXPECT_TRUE(list_.note({&other, 1}, true));
  EXPECT_TRUE(list_.note({&other, 1}, false));
  EXPECT_TRUE(list_.note({&one, 1}, true));
  EXPECT_EQ(list_.size(), 2U);
  EXPECT_THAT(list_.pairs(crew_, room_), ElementsAre(SlotPair{1, 2}, SlotPair{4, 5}));
}

TEST_P(CandidateListTest, IsWhatItWasWhenNotesAreForgotten) {
  Parts found{{1, 2}, {4, 5}};
  list_.replace(found.view());
  const std::uint64_t one = pair_key(SlotPair{4, 5});
  const std::uint64_t other = pair_key(SlotPair{7, 8});
  list_.begin_notes(crew_, room_);
  EXPECT_TRUE(list_.note({&one, 1}, false));
  list_.begin_notes(crew_, room_);
  EXPECT_TRUE(list_.note({&one, 1}, true));
  EXPECT_TRUE(list_.note({&other, 1}, true));
  list_.forget_notes();
  EXPECT_EQ(list_.size(), 1U);
  EXPECT_THAT(list_.pairs(crew_, room_), ElementsAre(SlotPair{1, 2}));
}

TEST_P(CandidateListTest, TakesNoMoreNotesInOneUpdateThanItHasUseFor) {
  Parts found{{1, 2}, {4, 5}};
  list_.replace(found.view());
  std::vector<std::uint64_t> keys;
  for (Slot slot = 10; slot < 10 + tuning::kManyNotes; ++slot) keys.push_back(pair_key(SlotPair{0, slot}));
  list_.begin_notes(crew_, room_);
  EXPECT_TRUE(list_.note(keys, true));
  EXPECT_TRUE(list_.note(std::span(keys).first(1), false));
  EXPECT_FALSE(list_.note(std::span(keys).first(1), true));
  EXPECT_EQ(list_.size(), 1 + keys.size());
  list_.begin_notes(crew_, room_);
  EXPECT_TRUE(list_.note(std::span(keys).first(1), true));
}

TEST_P(CandidateListTest, GivesBackWhatItHasNoUseFor) {
  Parts found{};
  for (Slot slot = 1; slot < 100'000; ++slot) found.add(0, {0, slot});
  list_.replace(found.view());
  EXPECT_EQ(list_.pairs(crew_, room_).size(), 99'999U);
  Parts few{{1, 2}, {4, 5}};
  list_.replace(few.view());
  EXPECT_EQ(list_.pairs(crew_, room_).size(), 2U);
  list_.give_back(crew_);
  EXPECT_LE(list_.bytes(), 64U << 10);
  EXPECT_THAT(list_.pairs(crew_, room_), ElementsAre(SlotPair{1, 2}, SlotPair{4, 5}));
}

// The keys that it was given lie in memory that goes, too.
TEST_P(CandidateListTest, KeepsWhatIsNotedAndWhatItWasGivenWhenItGivesBack) {
  {
    Parts found{{4, 5}, {1, 2}, {8, 9}};
    list_.replace(found.view());
    list_.begin_notes(crew_, room_);
    const std::vector<std::uint64_t> began = {pair_key(SlotPair{2, 7}), pair_key(SlotPair{0, 1})};
    const std::vector<std::uint64_t> ended = {pair_key(SlotPair{4, 5})};
    EXPECT_TRUE(list_.note(began, true));
    EXPECT_TRUE(list_.note(ended, false));
    list_.give_back(crew_);
    EXPECT_THAT(list_.found(), IsEmpty());
  }
  EXPECT_EQ(list_.size(), 4U);
  EXPECT_THAT(list_.pairs(crew_, room_),
              ElementsAre(SlotPair{0, 1}, SlotPair{1, 2}, SlotPair{2, 7}, SlotPair{8, 9}));
}

TEST_P(CandidateListTest, StaysAsItIsWhenNothingChanges) {
  Parts found{{1, 2}, {4, 5}};
  list_.replace(found.view());
  Parts none(2);
  const SlotPairChanges changes = list_.change(crew_, room_, none.view(), changed({7}));
  EXPECT_THAT(changes.began, IsEmpty());
  EXPECT_THAT(changes.ended, IsEmpty());
  EXPECT_THAT(list_.pairs(crew_, room_), ElementsAre(SlotPair{1, 2}, SlotPair{4, 5}));
}

TEST_P(CandidateListTest, ChangesOneByOneAmountToTheSameSet) {
  Random random(2);
  std::set<SlotPair> truth;
  for (int round = 0; round < contract::effort(200, 40, 40); ++round) {
    const std::size_t bodies = round % 10 == 0 ? 300 : 3;
    std::vector<Slot> slots(bodies);
    for (Slot& slot : slots) slot = static_cast<Slot>(random.below(kSlots));
    const std::uint8_t* const flags = changed(slots);
    std::set<SlotPair> next = truth;
    std::erase_if(next, [&](const SlotPair& pair) { return touches(pair) && random.one_in(3); });
    for (const Slot slot : slots) {
      for (std::size_t i = random.below(20); i > 0; --i) {
        const auto other = static_cast<Slot>(random.below(kSlots));
        if (other != slot) next.insert(make_slot_pair(slot, other));
      }
    }
    Parts touched(3);
    Parts all(3);
    std::vector<std::uint64_t> began;
    std::vector<std::uint64_t> ended;
    for (const SlotPair& pair : next) {
      all.add(random.below(3), pair);
      if (touches(pair)) touched.add(random.below(3), pair);
      if (!truth.contains(pair)) began.push_back(pair_key(pair));
    }
    for (const SlotPair& pair : truth) {
      if (!next.contains(pair)) ended.push_back(pair_key(pair));
    }
    truth = std::move(next);
    if (round % 7 == 3) {
      list_.replace(all.view());
    } else if (round % 3 == 0) {
      list_.change(crew_, room_, touched.view(), flags);
    } else {
      list_.begin_notes(crew_, room_);
      ASSERT_TRUE(list_.note(ended, false));
      ASSERT_TRUE(list_.note(began, true));
    }
    ASSERT_EQ(list_.size(), truth.size());
    if (round % 2 == 0 && round % 7 != 3) continue;
    // Keys stay where they are until the next call; here they do not outlive the round.
    ASSERT_TRUE(std::ranges::equal(list_.pairs(crew_, room_), truth)) << "round " << round;
  }
  EXPECT_GE(list_.bytes(), truth.size() * sizeof(SlotPair));
}

INSTANTIATE_TEST_SUITE_P(Workers, CandidateListTest, numbers_of_workers());

}  // namespace
}  // namespace cellsweep::stream
