/// @file
/// Pairs of slots become pairs of ids, ascending, whatever the ids and however many the pairs.
#include "broadphase/pairs/pair_order.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "base/memory/starved.h"
#include "base/threads/numbers_of_workers.h"
#include "base/threads/thread_pool.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using testing::ElementsAre;

using Ids = std::vector<BodyId>;

/// Slots with ids, and pairs of them as an engine hands them over.
class PairOrderTest : public testing::TestWithParam<unsigned> {
 protected:
  void hold(const Ids& ids) {
    table_ = {};
    List<Slot> slots;
    ASSERT_TRUE(table_.insert(ids, slots));
  }
  void replace(BodyId gone, BodyId next) {
    List<Slot> slots;
    table_.reserve_removals(1);
    table_.remove(table_.find(gone));
    ASSERT_TRUE(table_.insert({&next, 1}, slots));
  }

  /// So many different pairs of any slots.
  std::set<SlotPair> random_pairs(std::size_t count) {
    std::set<SlotPair> pairs;
    while (pairs.size() < count) {
      const auto one = static_cast<Slot>(random_.below(table_.slot_count()));
      const auto other = static_cast<Slot>(random_.below(table_.slot_count()));
      if (one != other) pairs.insert(make_slot_pair(one, other));
    }
    return pairs;
  }

  std::vector<Pair> name(const std::vector<SlotPair>& ascending,
                         const std::vector<std::vector<std::uint64_t>>& more) {
    const std::vector<std::span<const std::uint64_t>> parts(more.begin(), more.end());
    order_.name_pairs(crew_, table_, ascending, parts, named_);
    return {named_.view().begin(), named_.view().end()};
  }

  std::vector<Pair> truth(const std::set<SlotPair>& pairs) const {
    std::vector<Pair> all;
    for (const SlotPair& pair : pairs) all.push_back(make_pair_of(table_.id(pair.a), table_.id(pair.b)));
    std::sort(all.begin(), all.end());
    return all;
  }

  /// Expects right names for so many pairs: in one ascending list, in parts in no order, and some of either.
  void expect_right(std::size_t count) {
    const std::set<SlotPair> pairs = random_pairs(count);
    const std::vector<Pair> expected = truth(pairs);
    std::vector<SlotPair> listed;
    std::vector<std::vector<std::uint64_t>> all_in_parts(4);
    std::vector<std::vector<std::uint64_t>> others(3);
    for (const SlotPair& pair : pairs) {
      all_in_parts[random_.below(3)].push_back(pair_key(pair));
      if (random_.one_in(2)) {
        listed.push_back(pair);
      } else {
        others[random_.below(3)].push_back(pair_key(pair));
      }
    }
    for (auto& part : all_in_parts) random_.shuffle(part);
    for (auto& part : others) random_.shuffle(part);
    ASSERT_EQ(name({pairs.begin(), pairs.end()}, {}), expected) << count << " pairs in a list";
    ASSERT_EQ(name({}, all_in_parts), expected) << count << " pairs in parts";
    ASSERT_EQ(name(listed, others), expected) << count << " pairs, some in a list";
  }

  // Fewer and more than it takes to sort by ranks and by several workers.
  void expect_right() {
    for (const std::size_t count : {0, 1, 2, 30, 700, 5000, 20'000}) expect_right(count);
  }

  Random random_{1};
  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
  IdTable table_;
  PairOrder order_;
  Array<Pair> named_;
};

constexpr std::size_t kSlots = 1500;

Ids ids_in_steps(BodyId first, BodyId step) {
  Ids ids(kSlots);
  for (BodyId i = 0; i < kSlots; ++i) ids[i] = first + step * i;
  return ids;
}

TEST_P(PairOrderTest, WhereIdsAreSlots) {
  hold(ids_in_steps(0, 1));
  ASSERT_TRUE(table_.is_identical());
  expect_right();
}

TEST_P(PairOrderTest, WhereSlotsAreInTheOrderOfIds) {
  hold(ids_in_steps(7, 2'000'003));
  ASSERT_TRUE(table_.is_ascending() && !table_.is_identical());
  expect_right();
}

TEST_P(PairOrderTest, WhereIdsAreInNoOrder) {
  Ids ids = ids_in_steps(0xffffffff, ~BodyId{0} - 2'000'003);
  random_.shuffle(ids);
  hold(ids);
  ASSERT_FALSE(table_.is_ascending());
  expect_right();
}

TEST_P(PairOrderTest, WhereDenseIdsAreInNoOrder) {
  Ids ids = ids_in_steps(0, 1);
  random_.shuffle(ids);
  hold(ids);
  expect_right();
}

TEST_P(PairOrderTest, WhereIdsDescend) {
  Ids ids = ids_in_steps(0, 2'000'003);
  std::reverse(ids.begin(), ids.end());
  hold(ids);
  expect_right();
}

TEST_P(PairOrderTest, AfterBodiesCameAndWent) {
  hold(ids_in_steps(0, 1));
  expect_right();
  for (const BodyId id : {5U, 900U, 1499U}) {
    replace(id, id + 1'000'000);
    expect_right();
    table_.release();
    replace(id + 1'000'000, id);
    expect_right();
  }
}

TEST_P(PairOrderTest, PairsThatEndAreNamedByTheIdsOfBodiesThatAreGone) {
  hold({30, 10, 20});
  replace(10, 10);
  EXPECT_THAT(name({{0, 1}, {1, 2}}, {}), ElementsAre(Pair{10, 20}, Pair{10, 30}));
  EXPECT_THAT(name({{0, 3}, {2, 3}}, {}), ElementsAre(Pair{10, 20}, Pair{10, 30}));
  replace(20, 5);
  EXPECT_THAT(name({{0, 2}, {1, 2}}, {}), ElementsAre(Pair{10, 20}, Pair{20, 30}));
}

TEST_P(PairOrderTest, IsRightWhenAllBodiesHaveBeenReplacedByOthers) {
  hold({20, 10});
  EXPECT_THAT(name({{0, 1}}, {}), ElementsAre(Pair{10, 20}));
  table_.reserve_removals(2);
  table_.remove(0);
  table_.remove(1);
  EXPECT_THAT(name({{0, 1}}, {}), ElementsAre(Pair{10, 20}));
  table_.release();
  List<Slot> slots;
  ASSERT_TRUE(table_.insert(Ids{7, 5}, slots));
  EXPECT_THAT(name({{0, 1}}, {}), ElementsAre(Pair{5, 7}));
}

TEST_P(PairOrderTest, IsRightAfterMemoryFailed) {
  Ids ids = ids_in_steps(3, 2'000'003);
  random_.shuffle(ids);
  for (const bool in_order : {true, false}) {
    for (const std::size_t count : {30, 3000}) {
      Ids some = ids;
      if (in_order) std::sort(some.begin(), some.end());
      hold(some);
      const std::set<SlotPair> pairs = random_pairs(count);
      const std::vector<SlotPair> list(pairs.begin(), pairs.end());
      std::vector<std::uint64_t> keys;
      for (const SlotPair& pair : pairs) keys.push_back(pair_key(pair));
      const std::span<const std::uint64_t> part = keys;
      for (std::uint64_t n = 1;; ++n) {
        order_ = {};
        named_ = {};
        const bool failed = fails_at(n, [&] { order_.name_pairs(crew_, table_, {}, {&part, 1}, named_); });
        ASSERT_EQ(name(list, {}), truth(pairs));
        if (failed) continue;
        EXPECT_GT(n, 2U);
        break;
      }
    }
  }
}

TEST_P(PairOrderTest, NeedsNoMoreMemoryForAsManyPairsAgain) {
  Ids ids = ids_in_steps(3, 2'000'003);
  random_.shuffle(ids);
  hold(ids);
  expect_right(5000);
  const std::size_t bytes = order_.bytes();
  EXPECT_GT(bytes, 5000U * sizeof(std::uint64_t));
  expect_right(5000);
  EXPECT_EQ(order_.bytes(), bytes);
}

INSTANTIATE_TEST_SUITE_P(Workers, PairOrderTest, numbers_of_workers());

}  // namespace
}  // namespace cellsweep
