/// @file
/// Ids to slots and back, dense, scattered and mixed.
#include "broadphase/bodies/id_table.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "base/memory/starved.h"
#include "base/tuning.h"
#include "broadphase/bodies/id_tables.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// All that a table shows, but for how often it changed.
struct Contents {
  std::size_t size;
  bool identical;
  bool ascending;
  bool full;
  std::vector<BodyId> ids;
  std::vector<Slot> slots;

  friend bool operator==(const Contents&, const Contents&) = default;
};

void PrintTo(const Contents& all, std::ostream* out) {
  *out << all.size << " bodies, identical " << all.identical << ", ascending " << all.ascending << ", full "
       << all.full << ", ids " << testing::PrintToString(all.ids);
}

// Of slots that nobody has, ids mean nothing.
Contents contents_of(const IdTable& table) {
  Contents all{table.size(), table.is_identical(), table.is_ascending(), table.is_full(), {}, {}};
  for (Slot slot = 0; slot < table.slot_count(); ++slot) {
    const BodyId id = table.ids()[slot];
    EXPECT_EQ(table.id(slot), id);
    all.ids.push_back(table.find(id) == slot ? id : kNoSlot);
    all.slots.push_back(table.find(id) == slot ? slot : kNoSlot);
  }
  return all;
}

TEST(IdTable, OfNobodyIsEmpty) {
  const IdTable table;
  EXPECT_EQ(table.size(), 0U);
  EXPECT_EQ(table.slot_count(), 0U);
  EXPECT_EQ(table.bytes(), 0U);
  EXPECT_TRUE(table.is_full());
  EXPECT_FALSE(table.is_sparse());
  for (const BodyId id : {0U, 5U, 0xffffffffU}) EXPECT_EQ(table.find(id), kNoSlot);
}

TEST(IdTable, GivesSlotsOutInOrderWhateverTheIds) {
  IdTable table;
  EXPECT_THAT(insert(table, {700, 0xffffffff, 0}), ElementsAre(0U, 1U, 2U));
  EXPECT_THAT(insert(table, {}), IsEmpty());
  EXPECT_THAT(insert(table, {5}), ElementsAre(3U));
  EXPECT_EQ(table.find(0xffffffff), 1U);
  EXPECT_EQ(table.find(0), 2U);
  EXPECT_EQ(table.id(1), 0xffffffffU);
  EXPECT_EQ(table.size(), 4U);
  EXPECT_EQ(table.slot_count(), 4U);
}

TEST(IdTable, AppendsSlotsToThoseThatAreListed) {
  IdTable table;
  List<Slot> slots;
  slots.resize(1, 99);
  ASSERT_TRUE(table.insert(Ids{4, 3}, slots));
  ASSERT_TRUE(table.insert(Ids{2}, slots));
  EXPECT_THAT(slots.view(), ElementsAre(99U, 0U, 1U, 2U));
}

TEST(IdTable, GivesOutTheLowestOfSlotsThatWereFreedTogether) {
  IdTable table = table_of({0, 1, 2, 3, 4, 5});
  remove(table, {4, 1, 3});
  table.release();
  EXPECT_THAT(insert(table, {1, 40, 50, 60}), ElementsAre(1U, 3U, 4U, 6U));
}

TEST(IdTable, KeepsTheSlotOfARemovedBodyUntilRelease) {
  IdTable table = table_of({10, 11, 12});
  remove(table, {11});
  EXPECT_EQ(table.find(11), kNoSlot);
  EXPECT_EQ(table.id(1), 11U);
  EXPECT_FALSE(table.is_full());
  EXPECT_THAT(insert(table, {13}), ElementsAre(3U));
  EXPECT_EQ(table.id(1), 11U);
  table.release();
  EXPECT_THAT(insert(table, {14}), ElementsAre(1U));
  EXPECT_TRUE(table.is_full());
}

TEST(IdTable, HasABodyThatComesBackBeforeReleaseInAnotherSlot) {
  for (const BodyId id : {0U, 1U, 7'000'000U, 0xffffffffU}) {
    IdTable table = table_of({id, 5});
    for (int round = 0; round < 3; ++round) {
      const Slot before = table.find(id);
      remove(table, {id});
      const Slot now = insert(table, {id})[0];
      EXPECT_NE(now, before);
      EXPECT_EQ(table.find(id), now);
      EXPECT_EQ(table.id(before), id) << "the pairs that end are still named by it";
      EXPECT_FALSE(table.is_ascending()) << "of two slots with one id none is first";
    }
    table.release();
    EXPECT_EQ(table.size(), 2U);
    EXPECT_EQ(table.slot_count(), 5U);
  }
}

TEST(IdTable, KnowsWhenIdsAreSlots) {
  IdTable table = table_of({0, 1, 2});
  EXPECT_TRUE(table.is_identical());
  remove(table, {1});
  EXPECT_TRUE(table.is_identical());
  table.release();
  insert(table, {1, 3});
  EXPECT_TRUE(table.is_identical());
  insert(table, {5});
  EXPECT_FALSE(table.is_identical());
  EXPECT_FALSE(table_of({1, 0}).is_identical());
}

TEST(IdTable, KnowsWhenSlotsAreInTheOrderOfTheirIds) {
  IdTable table = table_of({3, 8});
  EXPECT_TRUE(table.is_ascending());
  insert(table, {9, 1000, 0xffffffff});
  EXPECT_TRUE(table.is_ascending());
  remove(table, {9});
  table.release();
  insert(table, {500});
  EXPECT_TRUE(table.is_ascending()) << "it took the place between 8 and 1000";
  remove(table, {500});
  table.release();
  insert(table, {2});
  EXPECT_FALSE(table.is_ascending());
  EXPECT_FALSE(table_of({8, 3}).is_ascending());
}

TEST(IdTable, StartsAnewWhenNobodyIsLeft) {
  IdTable table = table_of({9, 3, 0xffffffff});
  const std::uint64_t version = table.version();
  remove(table, {3, 0xffffffff, 9});
  EXPECT_EQ(table.slot_count(), 3U);
  EXPECT_GT(table.bytes(), 0U);
  table.release();
  EXPECT_EQ(table.slot_count(), 0U);
  EXPECT_EQ(table.bytes(), 0U);
  EXPECT_TRUE(table.is_identical());
  EXPECT_TRUE(table.is_ascending());
  EXPECT_GT(table.version(), version);
  EXPECT_THAT(insert(table, {0}), ElementsAre(0U));
}

TEST(IdTable, CountsWhatChangesAboutSlots) {
  IdTable table = table_of({1, 2});
  std::uint64_t version = table.version();
  const auto has_changed = [&] { return std::exchange(version, table.version()) != table.version(); };
  insert(table, {7});
  EXPECT_TRUE(has_changed());
  remove(table, {1});
  EXPECT_TRUE(has_changed());
  insert(table, {1});
  EXPECT_TRUE(has_changed());
  EXPECT_EQ(table.find(7), 2U);
  EXPECT_FALSE(has_changed());
}

TEST(IdTable, TakesOverNothingWhenDenseIdsReachWhereScatteredOnesWere) {
  IdTable table = table_of({40'000});
  Ids dense(30'000);
  std::iota(dense.begin(), dense.end(), 0);
  insert(table, dense);
  Ids more(20'000);
  std::iota(more.begin(), more.end(), 40'001);
  insert(table, more);
  EXPECT_EQ(table.find(40'000), 0U);
  EXPECT_EQ(table.find(29'999), 30'000U);
  EXPECT_EQ(table.find(60'000), 50'000U);
  List<Slot> slots;
  EXPECT_FALSE(table.insert(Ids{40'000}, slots));
  remove(table, {40'000});
  EXPECT_EQ(table.find(40'000), kNoSlot);
  insert(table, {40'000});
  EXPECT_EQ(table.find(40'000), 50'001U);
}

/// The table holds what the map does, and its flags are true.
void expect_right(const IdTable& table, const std::map<BodyId, Slot>& truth,
                  const std::map<Slot, BodyId>& waiting) {
  ASSERT_EQ(table.size(), truth.size());
  bool identical = true;
  std::map<Slot, BodyId> by_slot = waiting;
  for (const auto& [id, slot] : truth) {
    ASSERT_EQ(table.find(id), slot);
    ASSERT_LT(slot, table.slot_count());
    ASSERT_TRUE(by_slot.emplace(slot, id).second) << "two bodies share a slot";
    identical = identical && id == slot;
  }
  for (const auto& [slot, id] : by_slot) ASSERT_EQ(table.id(slot), id);
  const bool ascending = std::ranges::adjacent_find(by_slot, [](const auto& one, const auto& other) {
                           return one.second >= other.second;
                         }) == by_slot.end();
  EXPECT_TRUE(identical || !table.is_identical());
  EXPECT_TRUE(ascending || !table.is_ascending());
  EXPECT_EQ(table.is_full(), truth.size() == table.slot_count());
}

TEST(IdTable, AgreesWithMapsOverThousandsOfRandomCalls) {
  contract::Random random(1);
  IdTable table;
  std::map<BodyId, Slot> truth;
  std::map<Slot, BodyId> waiting;
  int refused = 0;
  for (int call = 0; call < 4000; ++call) {
    Ids ids(random.below(random.one_in(50) ? 200 : 5));
    for (BodyId& id : ids) id = random_id(random);
    std::set<BodyId> different(ids.begin(), ids.end());
    if (random.one_in(2)) {
      List<Slot> slots;
      const bool good = different.size() == ids.size() &&
                        std::ranges::none_of(ids, [&](BodyId id) { return truth.contains(id); });
      ASSERT_EQ(table.insert(ids, slots), good);
      ASSERT_EQ(slots.size(), good ? ids.size() : 0);
      for (std::size_t i = 0; i < slots.size(); ++i) truth[ids[i]] = slots[i];
      refused += good ? 0 : 1;
    } else {
      std::erase_if(different, [&](BodyId id) { return !truth.contains(id); });
      remove(table, {different.begin(), different.end()});
      for (const BodyId id : different) {
        waiting[truth[id]] = id;
        truth.erase(id);
      }
    }
    if (random.one_in(4)) {
      table.release();
      waiting.clear();
    }
    expect_right(table, truth, waiting);
    if (HasFailure()) return;
  }
  EXPECT_GT(refused, 500);
}

class RefusedInsert : public testing::TestWithParam<Ids> {
 protected:
  static void expect_nothing_changed(IdTable& table) {
    const Contents before = contents_of(table);
    const std::uint64_t version = table.version();
    List<Slot> slots;
    slots.resize(1, 77);
    EXPECT_FALSE(table.insert(GetParam(), slots));
    EXPECT_THAT(slots.view(), ElementsAre(77U));
    EXPECT_EQ(contents_of(table), before);
    EXPECT_EQ(table.version(), version);
  }
};

// Body 8 is held in all of these.
TEST_P(RefusedInsert, ChangesNothingInAFullTable) {
  for (const Ids& held :
       {Ids{8}, Ids{0, 1, 2, 3, 4, 5, 6, 7, 8}, Ids{8, 0xfffffffe}, Ids{1, 8, 30'000'000}}) {
    IdTable table = table_of(held);
    expect_nothing_changed(table);
    EXPECT_THAT(insert(table, {5000, 6000}), ElementsAre(held.size(), held.size() + 1));
  }
}

TEST_P(RefusedInsert, ChangesNothingWhereSlotsAreFree) {
  for (const Ids& freed : {Ids{0}, Ids{3, 5}, Ids{0, 1, 2, 3, 4, 5, 6, 7}}) {
    IdTable table = table_of({0, 1, 2, 3, 4, 5, 6, 7, 8});
    remove(table, freed);
    table.release();
    expect_nothing_changed(table);
    EXPECT_TRUE(table.is_identical());
    EXPECT_TRUE(table.is_ascending());
    EXPECT_EQ(insert(table, freed), freed) << "the same slots are free";
  }
}

TEST_P(RefusedInsert, ChangesNothingWhereSlotsWaitForRelease) {
  IdTable table = table_of({0, 1, 2, 8, 100, 200});
  remove(table, {1, 200});
  expect_nothing_changed(table);
  EXPECT_EQ(table.id(1), 1U);
  EXPECT_EQ(table.id(5), 200U);
  table.release();
  EXPECT_THAT(insert(table, {1, 200}), ElementsAre(1U, 5U));
}

INSTANTIATE_TEST_SUITE_P(AtEveryPlace, RefusedInsert,
                         testing::Values(Ids{8}, Ids{8, 300, 301}, Ids{300, 8, 301}, Ids{300, 301, 8},
                                         Ids{300, 300}, Ids{0xffffffff, 300, 0xffffffff},
                                         Ids{9, 40'000'000, 10, 40'000'000, 11},
                                         Ids{12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 8}));

TEST(RenumberedIds, HaveSlotsWithoutGapsInTheSameOrder) {
  Ids ids;
  for (BodyId id = 0; id < 3000; ++id) ids.push_back(3 * id);
  std::swap(ids[0], ids[30]);
  IdTable table = table_of(ids);
  EXPECT_FALSE(table.is_sparse());
  Ids gone;
  for (const BodyId id : ids) {
    if (id % 30 != 0) gone.push_back(id);
  }
  remove(table, gone);
  table.release();
  EXPECT_TRUE(table.is_sparse());

  List<Slot> before;
  const IdTable renumbered = table.renumbered(before);
  ASSERT_EQ(before.size(), 300U);
  EXPECT_EQ(renumbered.size(), 300U);
  EXPECT_EQ(renumbered.slot_count(), 300U);
  EXPECT_TRUE(renumbered.is_full());
  EXPECT_FALSE(renumbered.is_sparse());
  EXPECT_FALSE(renumbered.is_ascending());
  EXPECT_GT(renumbered.version(), table.version());
  EXPECT_LT(renumbered.bytes(), table.bytes());
  EXPECT_TRUE(std::is_sorted(before.begin(), before.end()));
  for (Slot slot = 0; slot < before.size(); ++slot) {
    EXPECT_EQ(renumbered.id(slot), table.id(before[slot]));
    EXPECT_EQ(renumbered.find(renumbered.id(slot)), slot);
  }
}

TEST(RenumberedIds, OfManyBodiesAreNotSparse) {
  Ids ids(2000);
  std::iota(ids.begin(), ids.end(), 0);
  IdTable table = table_of(ids);
  remove(table, {ids.begin(), ids.begin() + 1500});
  table.release();
  EXPECT_FALSE(table.is_sparse()) << "a quarter is left";
  remove(table, {1500});
  EXPECT_TRUE(table.is_sparse());
  IdTable small = table_of({ids.begin(), ids.begin() + 1000});
  remove(small, {ids.begin(), ids.begin() + 999});
  EXPECT_FALSE(small.is_sparse()) << "there is little to gain";
}

TEST(IdTableWithoutMemory, IsAsItWasWhereverThatHappens) {
  Ids dense(5000);
  std::iota(dense.begin(), dense.end(), 100);
  Ids mixed = dense;
  for (BodyId i = 0; i < 3000; ++i) mixed.push_back(0xffffffffU - 1000 * i);
  const auto make = [] {
    IdTable table = table_of({0, 1, 2, 3, 0xfffffffe});
    remove(table, {1});
    table.release();
    remove(table, {2});
    return table;
  };
  const Contents before = contents_of(make());
  List<Slot> slots;
  const auto is_kept = [&](const IdTable& table) {
    EXPECT_EQ(contents_of(table), before);
    EXPECT_TRUE(slots.empty());
  };
  const auto insert_all = [&](IdTable& table) { ASSERT_TRUE(table.insert(mixed, slots)); };
  const std::uint64_t places = starve(make, insert_all, is_kept, [&](const IdTable& table) {
    for (std::size_t i = 0; i < mixed.size(); ++i) ASSERT_EQ(table.find(mixed[i]), slots[i]);
    slots = {};
  });
  EXPECT_GE(places, 4U);
  const auto room_to_remove = [](IdTable& table) { table.reserve_removals(100'000); };
  EXPECT_EQ(starve(make, room_to_remove, is_kept, is_kept), 2U);
}

/// So many ids from everywhere that they wait for their table.
Ids many_scattered_ids() {
  Ids ids(tuning::kTableWaits + 100);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<BodyId>((i + 1) * 2'654'435'761U);
  return ids;
}

TEST(IdTable, OfManyScatteredIdsIsMadeWhenOneIsLookedUp) {
  const Ids ids = many_scattered_ids();
  const IdTable table = table_of(ids);
  EXPECT_FALSE(table.has_table());
  EXPECT_EQ(table.find(ids[77]), 77U);
  EXPECT_TRUE(table.has_table());
  for (Slot slot = 0; slot < ids.size(); ++slot) ASSERT_EQ(table.find(ids[slot]), slot);
  EXPECT_EQ(table.find(5), kNoSlot);
}

TEST(IdTable, OfDenseOrOfFewIdsIsThereAtOnce) {
  Ids dense(2 * tuning::kTableWaits);
  std::iota(dense.begin(), dense.end(), 7);
  EXPECT_TRUE(table_of(dense).has_table());
  Ids few = many_scattered_ids();
  few.resize(100);
  EXPECT_TRUE(table_of(few).has_table());
}

TEST(IdTable, ThatWaitsTakesMoreAndLosesSome) {
  const Ids ids = many_scattered_ids();
  IdTable more = table_of(ids);
  EXPECT_THAT(insert(more, {1, 2}), ElementsAre(ids.size(), ids.size() + 1));
  EXPECT_EQ(more.find(ids[50]), 50U);
  EXPECT_EQ(more.find(2), ids.size() + 1);
  IdTable fewer = table_of(ids);
  remove(fewer, {ids[3], ids.back()});
  EXPECT_EQ(fewer.find(ids[3]), kNoSlot);
  EXPECT_EQ(fewer.find(ids[4]), 4U);
  EXPECT_EQ(fewer.size(), ids.size() - 2);
}

TEST(IdTable, RefusesManyIdsOfWhichTwoAreAlike) {
  Ids ids = many_scattered_ids();
  ids.back() = ids[10];
  IdTable table;
  List<Slot> slots;
  EXPECT_FALSE(table.insert(ids, slots));
  EXPECT_EQ(contents_of(table), contents_of(IdTable()));
  EXPECT_EQ(table.find(ids[0]), kNoSlot);
  ids.back() = 5;
  EXPECT_TRUE(table.insert(ids, slots));
  EXPECT_FALSE(table.insert(Ids{ids[77]}, slots));
  EXPECT_EQ(table.size(), ids.size());
}

TEST(IdTable, ThatWaitsIsMadeOnceForAllThreadsThatLookIdsUp) {
  const Ids ids = many_scattered_ids();
  for (int round = 0; round < 20; ++round) {
    const IdTable table = table_of(ids);
    std::vector<std::thread> threads;
    for (Slot first = 0; first < 4; ++first)
      threads.emplace_back([&, first] {
        for (Slot slot = first; slot < ids.size(); slot += 4) ASSERT_EQ(table.find(ids[slot]), slot);
      });
    for (std::thread& thread : threads) thread.join();
  }
}

TEST(IdTable, WaitsForItsTableWhereverItIsMovedTo) {
  const Ids ids = many_scattered_ids();
  IdTable first = table_of(ids);
  IdTable second = std::move(first);
  EXPECT_FALSE(second.has_table());
  IdTable third = table_of({1, 2});
  third = std::move(second);
  EXPECT_FALSE(third.has_table());
  EXPECT_EQ(third.find(ids[5]), 5U);
}

TEST(IdTable, ThatWaitsHasChangedInNothingWithoutMemory) {
  const Ids ids = many_scattered_ids();
  const Contents before = contents_of(table_of(ids));
  const auto is_kept = [&](const IdTable& table) { EXPECT_EQ(contents_of(table), before); };
  EXPECT_GE(starve([&] { return table_of(ids); },
                   [&](IdTable& table) { static_cast<void>(table.find(ids[0])); }, is_kept, is_kept),
            1U);
  EXPECT_GE(starve([&] { return table_of(ids); }, [](IdTable& table) { table.reserve_removals(3); }, is_kept,
                   is_kept),
            2U);
}

}  // namespace
}  // namespace cellsweep
