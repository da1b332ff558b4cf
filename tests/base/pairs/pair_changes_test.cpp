/// @file
/// What differs between two lists of pairs, and lists that follow changes, against sets.
#include "base/pairs/pair_changes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include "base/threads/thread_pool.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using testing::ElementsAreArray;
using testing::IsEmpty;

template <class AnyPair>
class PairChangesTest : public testing::Test {
 protected:
  using Pairs = std::vector<AnyPair>;
  using Set = std::set<AnyPair>;

  static Set random_set(Random& random, std::size_t count) {
    Set set;
    for (std::size_t i = 0; i < count; ++i) {
      const auto a = static_cast<std::uint32_t>(random.below(60));
      set.insert(AnyPair{a, static_cast<std::uint32_t>(a + 1 + random.below(60))});
    }
    return set;
  }
  static Pairs difference(const Set& one, const Set& other) {
    Pairs pairs;
    std::ranges::set_difference(one, other, std::back_inserter(pairs));
    return pairs;
  }
  static Pairs listed(const Set& set) { return {set.begin(), set.end()}; }

  void find(const Pairs& old, const Pairs& now, const std::vector<std::uint32_t>& gone = {}) {
    find_changes<AnyPair>(old, now, gone, began_, ended_);
  }

  Array<AnyPair> began_;
  Array<AnyPair> ended_;
  Array<AnyPair> now_;
};

using BothPairs = testing::Types<Pair, SlotPair>;
TYPED_TEST_SUITE(PairChangesTest, BothPairs, );

TYPED_TEST(PairChangesTest, BetweenEqualListsThereAreNone) {
  this->find({}, {});
  EXPECT_THAT(this->began_.view(), IsEmpty());
  this->find({{0, 1}, {2, 3}}, {{0, 1}, {2, 3}});
  EXPECT_THAT(this->began_.view(), IsEmpty());
  EXPECT_THAT(this->ended_.view(), IsEmpty());
}

TYPED_TEST(PairChangesTest, AreFoundAtBothEnds) {
  this->find({{0, 1}, {2, 3}, {2, 0xffffffff}}, {{0, 2}, {2, 3}, {5, 6}});
  EXPECT_THAT(this->began_.view(), ElementsAreArray({TypeParam{0, 2}, TypeParam{5, 6}}));
  EXPECT_THAT(this->ended_.view(), ElementsAreArray({TypeParam{0, 1}, TypeParam{2, 0xffffffff}}));
}

TYPED_TEST(PairChangesTest, PairsOfThoseWhoAreGoneEndAndBeginThoughTheyAreInBothLists) {
  const std::vector<TypeParam> pairs = {{1, 2}, {2, 3}, {3, 4}, {4, 5}};
  const std::vector<TypeParam> expected = {{1, 2}, {2, 3}, {4, 5}};
  this->find(pairs, pairs, {2, 5});
  EXPECT_THAT(this->began_.view(), ElementsAreArray(expected));
  EXPECT_THAT(this->ended_.view(), ElementsAreArray(expected));
}

TYPED_TEST(PairChangesTest, LeadFromOneListToTheNext) {
  Random random(1);
  for (int round = 0; round < 300; ++round) {
    const auto old = this->random_set(random, random.below(200));
    const auto now = this->random_set(random, random.below(200));
    this->find(this->listed(old), this->listed(now));
    EXPECT_THAT(this->began_.view(), ElementsAreArray(this->difference(now, old)));
    EXPECT_THAT(this->ended_.view(), ElementsAreArray(this->difference(old, now)));
    apply_changes<TypeParam>(this->listed(old), this->began_.view(), this->ended_.view(), this->now_);
    ASSERT_THAT(this->now_.view(), ElementsAreArray(now));
  }
}

// Few changes are looked for in the list, and of many none is.
TYPED_TEST(PairChangesTest, FewAndManyLeadToTheNextList) {
  Random random(6);
  for (std::size_t changes = 0; changes < 400; ++changes) {
    const auto old = this->random_set(random, 300);
    auto now = old;
    for (std::size_t i = 0; i < changes; ++i) {
      const auto pair = *this->random_set(random, 1).begin();
      const auto next = now.lower_bound(pair);
      if (random.below(2) == 0) {
        now.insert(pair);
      } else if (next != now.end()) {
        now.erase(next);
      }
    }
    apply_changes<TypeParam>(this->listed(old), this->difference(now, old), this->difference(old, now),
                             this->now_);
    ASSERT_THAT(this->now_.view(), ElementsAreArray(now)) << changes;
  }
}

TYPED_TEST(PairChangesTest, APairThatEndedAndBeganStays) {
  const std::vector<TypeParam> old = {{1, 2}, {3, 4}};
  const std::vector<TypeParam> both = {{3, 4}};
  apply_changes<TypeParam>(old, both, both, this->now_);
  EXPECT_THAT(this->now_.view(), ElementsAreArray(old));
}

TYPED_TEST(PairChangesTest, APairThatChangesTwiceIsAsItWas) {
  Random random(4);
  for (int round = 0; round < 300; ++round) {
    const auto old = this->random_set(random, random.below(100));
    auto now = old;
    std::vector<std::uint64_t> keys;
    for (std::size_t i = random.below(200); i > 0; --i) {
      const auto pair = *this->random_set(random, 1).begin();
      for (std::size_t times = random.below(4); times > 0; --times) {
        keys.push_back(pair_key(pair));
        if (now.erase(pair) == 0) now.insert(pair);
      }
    }
    std::ranges::sort(keys);
    apply_alternating<TypeParam>(this->listed(old), keys, this->now_);
    ASSERT_THAT(this->now_.view(), ElementsAreArray(now));
  }
}

TEST(PairChanges, MayBeWrittenOverTheListsThatTheyAreFoundIn) {
  Random random(5);
  for (int round = 0; round < 300; ++round) {
    const auto list = [&random, few = Slot{40}] {
      std::vector<SlotPair> pairs;
      for (Slot slot = 0; slot < few; ++slot)
        if (!random.one_in(4)) pairs.push_back({slot, slot + 1});
      return pairs;
    };
    std::vector<SlotPair> old = list(), now = list(), began, ended;
    std::ranges::set_difference(now, old, std::back_inserter(began));
    std::ranges::set_difference(old, now, std::back_inserter(ended));
    const ChangeRoom<SlotPair> ends = write_changes<SlotPair>(old, now, {}, {now.data(), old.data()});
    EXPECT_THAT(std::span(now.data(), ends.began), ElementsAreArray(began));
    EXPECT_THAT(std::span(old.data(), ends.ended), ElementsAreArray(ended));
  }
}

TEST(PairChanges, AreAppliedByAnyNumberOfWorkersAlike) {
  Random random(3);
  Array<SlotPair> now;
  for (const unsigned workers : {1U, 2U, 5U}) {
    Crew crew(std::make_shared<ThreadPool>(workers), workers, Crew::Choice::given);
    for (int round = 0; round < 200; ++round) {
      std::vector<SlotPair> old, began, ended, expected;
      const Slot last = round % 4 == 0 ? 5 : 300;
      for (Slot slot = 0; slot < last; ++slot) {
        const SlotPair pair{slot, slot + 1};
        const bool was = random.one_in(2), is = random.one_in(8) ? !was : was;
        if (was) old.push_back(pair);
        if (is) expected.push_back(pair);
        if (was != is) (is ? began : ended).push_back(pair);
      }
      apply_changes<SlotPair>(crew, old, began, ended, now);
      ASSERT_THAT(now.view(), ElementsAreArray(expected)) << workers << " workers, round " << round;
    }
  }
}

}  // namespace
}  // namespace cellsweep
