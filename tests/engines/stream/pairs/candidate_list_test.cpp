/// @file
/// The candidates of engine `stream`: found anew or changed one by one, always ascending.
#include "engines/stream/pairs/candidate_list.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/thread_pool.h"
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
  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
  CandidateList list_;
};

TEST_P(CandidateListTest, IsEmptyAtFirst) {
  EXPECT_EQ(list_.size(), 0U);
  EXPECT_THAT(list_.pairs(crew_), IsEmpty());
}

TEST_P(CandidateListTest, IsAscendingInWhicheverOrderPairsWereFound) {
  Parts found(3);
  found.add(0, {3, 4});
  found.add(2, {1, 9});
  found.add(0, {0, 2});
  found.add(2, {1, 2});
  list_.replace(found.view());
  EXPECT_EQ(list_.size(), 4U) << "before they are sorted";
  EXPECT_THAT(list_.pairs(crew_),
              ElementsAre(SlotPair{0, 2}, SlotPair{1, 2}, SlotPair{1, 9}, SlotPair{3, 4}));
  EXPECT_EQ(list_.size(), 4U);
}

TEST_P(CandidateListTest, IsReplacedByWhatIsFoundAnew) {
  Parts first{{1, 2}, {3, 4}};
  list_.replace(first.view());
  Parts second{{3, 4}, {0, 9}};
  EXPECT_THAT(list_.take(crew_), ElementsAre(SlotPair{1, 2}, SlotPair{3, 4}));
  EXPECT_EQ(list_.size(), 0U);
  list_.replace(second.view());
  EXPECT_THAT(list_.found(), testing::SizeIs(1));
  EXPECT_THAT(list_.pairs(crew_), ElementsAre(SlotPair{0, 9}, SlotPair{3, 4}));
  Parts none(2);
  list_.replace(none.view());
  EXPECT_EQ(list_.size(), 0U);
  EXPECT_THAT(list_.pairs(crew_), IsEmpty());
}

TEST_P(CandidateListTest, SaysWhatBeganAndEndedInOrder) {
  Parts found{{3, 4}, {1, 2}};
  list_.replace(found.view());
  Parts began{{5, 6}, {0, 1}};
  Parts ended{{3, 4}, {1, 2}};
  const SlotPairChanges changes = list_.change(crew_, began.view(), ended.view());
  EXPECT_THAT(changes.began, ElementsAre(SlotPair{0, 1}, SlotPair{5, 6}));
  EXPECT_THAT(changes.ended, ElementsAre(SlotPair{1, 2}, SlotPair{3, 4}));
  EXPECT_THAT(list_.pairs(crew_), ElementsAre(SlotPair{0, 1}, SlotPair{5, 6}));
}

TEST_P(CandidateListTest, APairThatBothBeganAndEndedDidNeither) {
  Parts found{{1, 2}, {4, 5}};
  list_.replace(found.view());
  Parts began{{1, 2}, {0, 9}, {7, 8}};
  Parts ended{{7, 8}, {1, 2}, {4, 5}};
  const SlotPairChanges changes = list_.change(crew_, began.view(), ended.view());
  EXPECT_THAT(changes.began, ElementsAre(SlotPair{0, 9}));
  EXPECT_THAT(changes.ended, ElementsAre(SlotPair{4, 5}));
  EXPECT_THAT(list_.pairs(crew_), ElementsAre(SlotPair{0, 9}, SlotPair{1, 2}));
}

TEST_P(CandidateListTest, OfSeveralNotesOnAPairTheLastCounts) {
  Parts found{{1, 2}, {4, 5}};
  list_.replace(found.view());
  Parts none(1);
  Parts one{{4, 5}};
  Parts other{{7, 8}};
  list_.note(crew_, none.view(), one.view());
  list_.note(crew_, other.view(), none.view());
  list_.note(crew_, one.view(), other.view());
  EXPECT_EQ(list_.size(), 2U);
  EXPECT_THAT(list_.pairs(crew_), ElementsAre(SlotPair{1, 2}, SlotPair{4, 5}));
}

TEST_P(CandidateListTest, StaysAsItIsWhenNothingChanges) {
  Parts found{{1, 2}, {4, 5}};
  list_.replace(found.view());
  Parts none(2);
  const SlotPairChanges changes = list_.change(crew_, none.view(), none.view());
  EXPECT_THAT(changes.began, IsEmpty());
  EXPECT_THAT(changes.ended, IsEmpty());
  EXPECT_THAT(list_.pairs(crew_), ElementsAre(SlotPair{1, 2}, SlotPair{4, 5}));
}

TEST_P(CandidateListTest, ChangesOneByOneAmountToTheSameSet) {
  Random random(2);
  const auto random_pair = [&] {
    const auto a = static_cast<Slot>(random.below(999));
    return SlotPair{a, static_cast<Slot>(a + 1 + random.below(999 - a))};
  };
  std::set<SlotPair> truth;
  for (int round = 0; round < 200; ++round) {
    std::set<SlotPair> next = truth;
    for (std::size_t i = random.below(round % 10 == 0 ? 5000 : 5); i > 0; --i) next.insert(random_pair());
    std::erase_if(next, [&](const SlotPair&) { return random.one_in(20); });
    Parts began(3);
    Parts ended(3);
    Parts all(3);
    for (const SlotPair& pair : next) {
      all.add(random.below(3), pair);
      if (!truth.contains(pair)) began.add(random.below(3), pair);
    }
    for (const SlotPair& pair : truth) {
      if (!next.contains(pair)) ended.add(random.below(3), pair);
    }
    truth = std::move(next);
    if (round % 7 == 3) {
      list_.replace(all.view());
    } else if (round % 3 == 0) {
      list_.change(crew_, began.view(), ended.view());
    } else {
      list_.note(crew_, began.view(), ended.view());
    }
    ASSERT_EQ(list_.size(), truth.size());
    if (round % 2 == 0 && round % 7 != 3) continue;
    // Keys stay where they are until the next call; here they do not outlive the round.
    ASSERT_TRUE(std::ranges::equal(list_.pairs(crew_), truth)) << "round " << round;
  }
  EXPECT_GE(list_.bytes(), truth.size() * sizeof(SlotPair));
}

INSTANTIATE_TEST_SUITE_P(Workers, CandidateListTest, testing::Values(1U, 3U));

}  // namespace
}  // namespace cellsweep::stream
