#include "engines/stream/pairs/pair_list.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <deque>
#include <set>

#include "base/pair_sort.h"
#include "contract/random.h"

namespace cellsweep::stream {
namespace {

using contract::Random;
using testing::ElementsAre;
using testing::IsEmpty;

/// Keys in several buffers, as workers leave them.
class Parts {
 public:
  explicit Parts(std::size_t count) : keys_(count) {
    for (Keys& keys : keys_) pointers_.push_back(&keys);
  }
  void add(std::size_t part, Pair pair) {
    KeyBuffer& buffer = keys_[part % keys_.size()].buffer();
    make_room(buffer, 1);
    buffer.keys[buffer.size++] = pair_key(pair);
  }
  std::span<Keys* const> view() const { return pointers_; }

 private:
  std::deque<Keys> keys_;
  std::vector<Keys*> pointers_;
};

/// Families of ids: dense, far apart, most on one body, two clumps with nothing between.
Pair random_pair(Random& random, int family) {
  const auto low = static_cast<BodyId>(random.below(family == 0 ? 3000 : 0x7fffffff));
  const auto other = static_cast<BodyId>(random.below(family == 0 ? 3000 : 0x7fffffff));
  if (family == 2) return make_pair_of(random.one_in(10) ? low : 5, 6 + other);
  if (family == 3)
    return make_pair_of(low % 900 + (random.one_in(2) ? 0xf0000000 : 0), 0xffff0000 + other % 900);
  return make_pair_of(low, low == other ? other + 1 : other);
}

TEST(PairSort, SortsAnyIdsWithAnyNumberOfWorkers) {
  Random random(1);
  for (const std::size_t count : {0, 1, 2, 25, 300, 3000, 30'000}) {
    for (int family = 0; family < 4; ++family) {
      std::set<Pair> pairs;
      for (std::size_t i = 0; i < count; ++i) pairs.insert(random_pair(random, family));
      for (const unsigned workers : {1U, 3U}) {
        Pool pool(workers);
        Parts parts(workers);
        std::vector<Pair> mixed(pairs.begin(), pairs.end());
        random.shuffle(mixed);
        for (std::size_t i = 0; i < mixed.size(); ++i) parts.add(i, mixed[i]);
        Array<std::uint64_t> scratch;
        Array<Pair> sorted;
        sort_pairs(pool, parts.view(), scratch, sorted);
        ASSERT_TRUE(std::ranges::equal(sorted.view(), pairs)) << count << " of family " << family;
      }
    }
  }
}

TEST(PairList, SaysWhatBeganAndEndedWhenAllIsFoundAnew) {
  Pool pool(1);
  PairList list;
  Parts first(2);
  first.add(0, {3, 4});
  first.add(1, {1, 2});
  PairChanges changes = list.replace(pool, first.view());
  EXPECT_THAT(changes.began, ElementsAre(Pair{1, 2}, Pair{3, 4}));
  EXPECT_THAT(changes.ended, IsEmpty());
  Parts second(1);
  second.add(0, {3, 4});
  second.add(0, {0, 9});
  changes = list.replace(pool, second.view());
  EXPECT_THAT(changes.began, ElementsAre(Pair{0, 9}));
  EXPECT_THAT(changes.ended, ElementsAre(Pair{1, 2}));
  EXPECT_THAT(list.pairs(), ElementsAre(Pair{0, 9}, Pair{3, 4}));
}

TEST(PairList, APairThatBothBeganAndEndedDidNeither) {
  Pool pool(1);
  PairList list;
  Parts all(1);
  all.add(0, {1, 2});
  list.replace(pool, all.view());
  Parts began(1);
  Parts ended(1);
  began.add(0, {1, 2});
  ended.add(0, {1, 2});
  const PairChanges changes = list.change(pool, began.view(), ended.view());
  EXPECT_THAT(changes.began, IsEmpty());
  EXPECT_THAT(changes.ended, IsEmpty());
  EXPECT_THAT(list.pairs(), ElementsAre(Pair{1, 2}));
}

TEST(PairList, ChangesOneByOneAmountToTheSameSet) {
  Random random(2);
  Pool pool(1);
  PairList list;
  std::set<Pair> truth;
  for (int round = 0; round < 200; ++round) {
    Parts began(1);
    Parts ended(1);
    std::set<Pair> next = truth;
    for (std::size_t i = random.below(round % 10 == 0 ? 500 : 5); i > 0; --i)
      next.insert(random_pair(random, 0));
    std::erase_if(next, [&](const Pair&) { return random.one_in(20); });
    for (const Pair& pair : next) {
      if (!truth.contains(pair)) began.add(0, pair);
    }
    for (const Pair& pair : truth) {
      if (!next.contains(pair)) ended.add(0, pair);
    }
    truth = std::move(next);
    list.change(pool, began.view(), ended.view());
    ASSERT_TRUE(std::ranges::equal(list.pairs(), truth)) << "round " << round;
  }
}

}  // namespace
}  // namespace cellsweep::stream
