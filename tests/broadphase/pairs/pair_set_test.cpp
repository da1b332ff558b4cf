/// @file
/// The set of pairs: what changed last, and the whole list whenever somebody asks for it.
#include "broadphase/pairs/pair_set.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <thread>
#include <vector>

#include "base/memory/starved.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using testing::ElementsAre;
using testing::IsEmpty;

using Pairs = std::vector<Pair>;

void write(const Pairs& pairs, Array<Pair>& list) {
  list.renew(pairs.size());
  std::ranges::copy(pairs, list.data());
}

/// One update, of which began and ended are known.
PairChanges update(PairSet& set, const Pairs& began, const Pairs& ended) {
  set.remember_changes();
  write(began, set.next_began());
  write(ended, set.next_ended());
  const PairChanges changes = set.next_changes();
  set.commit();
  return changes;
}

/// One update, of which all pairs are known.
PairChanges update_to(PairSet& set, const Pairs& all) {
  set.remember_changes();
  write(all, set.next_began());
  write({}, set.next_ended());
  set.compare_with_whole_set({});
  const PairChanges changes = set.next_changes();
  set.commit();
  return changes;
}

Pairs difference(const std::set<Pair>& one, const std::set<Pair>& other) {
  Pairs pairs;
  std::ranges::set_difference(one, other, std::back_inserter(pairs));
  return pairs;
}

TEST(PairSet, IsEmptyAtFirst) {
  PairSet set;
  EXPECT_THAT(set.pairs(), IsEmpty());
  EXPECT_EQ(set.bytes(), 0U);
  const PairChanges changes = update(set, {}, {});
  EXPECT_THAT(changes.began, IsEmpty());
  EXPECT_THAT(changes.ended, IsEmpty());
  EXPECT_THAT(set.pairs(), IsEmpty());
}

TEST(PairSet, SaysWhatTheLastUpdateChangedAndListsAll) {
  PairSet set;
  PairChanges changes = update(set, {{1, 2}, {3, 4}}, {});
  EXPECT_THAT(changes.began, ElementsAre(Pair{1, 2}, Pair{3, 4}));
  EXPECT_THAT(set.pairs(), ElementsAre(Pair{1, 2}, Pair{3, 4}));
  changes = update(set, {{0, 9}, {3, 5}}, {{1, 2}});
  EXPECT_THAT(changes.began, ElementsAre(Pair{0, 9}, Pair{3, 5}));
  EXPECT_THAT(changes.ended, ElementsAre(Pair{1, 2}));
  EXPECT_THAT(set.pairs(), ElementsAre(Pair{0, 9}, Pair{3, 4}, Pair{3, 5}));
  changes = update(set, {}, {{0, 9}, {3, 4}, {3, 5}});
  EXPECT_THAT(changes.began, IsEmpty());
  EXPECT_THAT(set.pairs(), IsEmpty());
}

TEST(PairSet, ShowsNothingOfAnUpdateThatDoesNotComeToItsEnd) {
  PairSet set;
  update(set, {{1, 2}, {3, 4}}, {});
  for (int attempt = 0; attempt < 3; ++attempt) {
    set.remember_changes();
    write({{5, 6}}, set.next_began());
    write({{1, 2}}, set.next_ended());
    EXPECT_THAT(set.pairs(), ElementsAre(Pair{1, 2}, Pair{3, 4}));
    set.compare_with_whole_set({});
    EXPECT_THAT(set.pairs(), ElementsAre(Pair{1, 2}, Pair{3, 4}));
  }
  update(set, {{7, 8}}, {});
  EXPECT_THAT(set.pairs(), ElementsAre(Pair{1, 2}, Pair{3, 4}, Pair{7, 8}));
}

TEST(PairSet, APairThatEndedAndBeganInOneUpdateIsThere) {
  for (const bool look : {false, true}) {
    PairSet set;
    update(set, {{1, 2}, {1, 3}, {5, 6}}, {});
    if (look) set.pairs();
    for (int round = 0; round < 3; ++round) {
      const PairChanges changes = update(set, {{1, 2}, {5, 6}}, {{1, 2}, {5, 6}});
      EXPECT_THAT(changes.began, ElementsAre(Pair{1, 2}, Pair{5, 6}));
      EXPECT_THAT(changes.ended, ElementsAre(Pair{1, 2}, Pair{5, 6}));
      if (!look) continue;
      EXPECT_THAT(set.pairs(), ElementsAre(Pair{1, 2}, Pair{1, 3}, Pair{5, 6}));
    }
    update(set, {}, {{5, 6}});
    EXPECT_THAT(set.pairs(), ElementsAre(Pair{1, 2}, Pair{1, 3}));
  }
}

TEST(PairSet, ForgetsNothingWhileNobodyLooks) {
  PairSet set;
  update(set, {{1, 2}, {3, 4}}, {});
  update(set, {{5, 6}}, {{1, 2}});
  update(set, {{1, 2}}, {{3, 4}});
  update(set, {}, {});
  update(set, {{3, 4}}, {{1, 2}, {5, 6}});
  update(set, {}, {});
  EXPECT_THAT(set.pairs(), ElementsAre(Pair{3, 4}));
}

TEST(PairSet, StartsWithEmptyUpdatesAsWell) {
  PairSet set;
  update(set, {}, {});
  update(set, {{1, 2}}, {});
  update(set, {}, {{1, 2}});
  update(set, {}, {});
  update(set, {{2, 3}}, {});
  EXPECT_THAT(set.pairs(), ElementsAre(Pair{2, 3}));
}

TEST(PairSet, HasTheListOfTheFirstPairsWithoutACopy) {
  PairSet set;
  const PairChanges changes = update(set, {{1, 2}, {3, 4}}, {});
  EXPECT_EQ(set.pairs().data(), changes.began.data());
}

TEST(PairSet, ListsStayValidUntilTheNextUpdate) {
  PairSet set;
  update(set, {{1, 2}, {3, 4}}, {});
  const PairChanges changes = update(set, {{0, 1}}, {{3, 4}});
  const std::span<const Pair> pairs = set.pairs();
  EXPECT_EQ(set.pairs().data(), pairs.data());
  EXPECT_THAT(changes.began, ElementsAre(Pair{0, 1}));
  EXPECT_THAT(changes.ended, ElementsAre(Pair{3, 4}));
  EXPECT_THAT(pairs, ElementsAre(Pair{0, 1}, Pair{1, 2}));
}

TEST(PairSet, FindsOutWhatAWholeSetChanged) {
  PairSet set;
  PairChanges changes = update_to(set, {{1, 2}, {3, 4}});
  EXPECT_THAT(changes.began, ElementsAre(Pair{1, 2}, Pair{3, 4}));
  EXPECT_THAT(changes.ended, IsEmpty());
  changes = update_to(set, {{0, 9}, {3, 4}});
  EXPECT_THAT(changes.began, ElementsAre(Pair{0, 9}));
  EXPECT_THAT(changes.ended, ElementsAre(Pair{1, 2}));
  changes = update_to(set, {{0, 9}, {3, 4}});
  EXPECT_THAT(changes.began, IsEmpty());
  EXPECT_THAT(changes.ended, IsEmpty());
  changes = update_to(set, {});
  EXPECT_THAT(changes.ended, ElementsAre(Pair{0, 9}, Pair{3, 4}));
  EXPECT_THAT(set.pairs(), IsEmpty());
}

/// A set and what should be in it, changed at random.
class RandomUpdates {
 public:
  RandomUpdates(std::uint64_t seed, std::size_t bodies, std::size_t pairs) : random_(seed), bodies_(bodies) {
    std::set<Pair> first;
    while (first.size() < pairs) first.insert(pair());
    step(first, 0);
  }

  /// About so many pairs begin and end.
  void change(std::size_t count) {
    std::set<Pair> next = truth_;
    for (std::size_t i = 0; i < count; ++i) {
      if (const Pair chosen = pair(); !next.erase(chosen)) next.insert(chosen);
    }
    step(next, count);
  }

  void expect_right() const { ASSERT_TRUE(std::ranges::equal(set_.pairs(), truth_)); }
  const PairSet& set() const { return set_; }
  Random& random() { return random_; }

 private:
  Pair pair() {
    const auto a = static_cast<BodyId>(random_.below(bodies_ - 1));
    return {a, static_cast<BodyId>(a + 1 + random_.below(bodies_ - 1 - a))};
  }

  void step(const std::set<Pair>& next, std::size_t count) {
    Pairs began = difference(next, truth_);
    Pairs ended = difference(truth_, next);
    PairChanges changes;
    if (random_.one_in(5)) {
      changes = update_to(set_, {next.begin(), next.end()});
    } else {
      // Bodies that were replaced: their pairs ended and began.
      for (const Pair& kept : next) {
        if (!truth_.contains(kept) || count == 0 || !random_.one_in(1 + next.size() / count)) continue;
        began.push_back(kept);
        ended.push_back(kept);
      }
      std::ranges::sort(began);
      std::ranges::sort(ended);
      changes = update(set_, began, ended);
    }
    ASSERT_TRUE(std::ranges::equal(changes.began, began));
    ASSERT_TRUE(std::ranges::equal(changes.ended, ended));
    truth_ = next;
  }

  Random random_;
  std::size_t bodies_;
  std::set<Pair> truth_;
  PairSet set_;
};

TEST(PairSet, IsRightAfterAnyUpdatesHoweverSeldomSomebodyLooks) {
  for (const std::size_t seldom : {1, 2, 7, 40}) {
    for (const std::size_t pairs : {0, 5, 300, 3000}) {
      RandomUpdates updates(seldom + pairs, 100, pairs);
      for (int step = 0; step < 120; ++step) {
        const std::size_t count = updates.random().one_in(10) ? 200 : updates.random().below(6);
        updates.change(count);
        if (updates.random().one_in(seldom)) updates.expect_right();
        if (testing::Test::HasFailure()) return;
      }
      updates.expect_right();
    }
  }
}

// There must be an end to what is remembered for somebody who never looks.
TEST(PairSet, RemembersNoMoreChangesThanAFewForEachPair) {
  PairSet set;
  Pairs some;
  Pairs others;
  for (BodyId id = 0; id < 2000; ++id) some.push_back({id, id + 1});
  for (BodyId id = 0; id < 400; ++id) others.push_back({id, id + 5000});
  update(set, some, {});
  for (int step = 0; step < 500; ++step) {
    update(set, others, {});
    update(set, {}, others);
    ASSERT_LT(set.bytes(), 300'000U) << "after " << step << " steps";
  }
  EXPECT_TRUE(std::ranges::equal(set.pairs(), some));
}

TEST(PairSet, MayBeLookedAtFromManyThreads) {
  RandomUpdates updates(2, 400, 5000);
  for (int step = 0; step < 20; ++step) {
    for (int unseen = step % 4; unseen >= 0; --unseen) updates.change(50);
    std::vector<std::thread> threads;
    std::vector<std::span<const Pair>> seen(6);
    for (std::span<const Pair>& pairs : seen) {
      threads.emplace_back([&] { pairs = updates.set().pairs(); });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::span<const Pair> pairs : seen) {
      EXPECT_EQ(pairs.data(), seen[0].data());
      EXPECT_EQ(pairs.size(), seen[0].size());
    }
    updates.expect_right();
  }
}

TEST(PairSet, MayBeLookedAtForTheFirstTimeFromManyThreads) {
  for (int round = 0; round < 20; ++round) {
    PairSet set;
    update(set, {{1, 2}, {3, 4}}, {});
    std::vector<std::thread> threads;
    std::vector<std::size_t> sizes(4);
    for (std::size_t& size : sizes) threads.emplace_back([&] { size = set.pairs().size(); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_THAT(sizes, testing::Each(2U));
  }
}

/// Sets that have come about in every way in which the next list is made.
std::unique_ptr<PairSet> make_set(int way) {
  auto set = std::make_unique<PairSet>();
  Pairs first;
  for (BodyId id = 0; id < 5000; ++id) first.push_back({id, id + 7});
  update(*set, first, {});
  if (way > 0) update(*set, {{0, 1}}, {{5, 12}});
  if (way > 1) update(*set, {{0, 2}}, {{0, 1}});
  if (way > 2) {
    Pairs many;
    for (BodyId id = 0; id < 6000; ++id) many.push_back({id, id + 9});
    update(*set, many, {});
  }
  return set;
}

class PairSetWithoutMemory : public testing::TestWithParam<int> {
 protected:
  static std::unique_ptr<PairSet> make() { return make_set(GetParam()); }

  static void expect_pairs(const PairSet& set, const Pairs& pairs) {
    std::uint64_t n = 1;
    while (fails_at(n, [&] { set.pairs(); })) ++n;
    EXPECT_TRUE(std::ranges::equal(set.pairs(), pairs));
  }

  /// Expects that a call, wherever it fails, leaves these pairs and afterwards makes those.
  template <class Call>
  static std::uint64_t starve_set(const Call& call, const Pairs& before, const Pairs& after) {
    return starve(
        make, [&](const std::unique_ptr<PairSet>& set) { call(*set); },
        [&](const std::unique_ptr<PairSet>& set) { expect_pairs(*set, before); },
        [&](const std::unique_ptr<PairSet>& set) { expect_pairs(*set, after); });
  }
};

TEST_P(PairSetWithoutMemory, HasTheSamePairsWhereverItFails) {
  const auto reference = make();
  const Pairs before(reference->pairs().begin(), reference->pairs().end());
  Pairs many;
  for (BodyId id = 0; id < 20'000; ++id) many.push_back({id, id + 50'000});
  Pairs after;
  std::ranges::merge(before, many, std::back_inserter(after));
  std::erase(after, Pair{7, 14});

  const auto look = [](PairSet& set) { set.pairs(); };
  EXPECT_EQ(starve_set(look, before, before) > 0, GetParam() > 0) << "the first list is there already";
  starve_set([](PairSet& set) { set.remember_changes(); }, before, before);
  EXPECT_GE(starve_set([&](PairSet& set) { update(set, many, {{7, 14}}); }, before, after), 1U);
  EXPECT_GE(starve_set([&](PairSet& set) { update_to(set, after); }, before, after), 2U);
}

INSTANTIATE_TEST_SUITE_P(Ways, PairSetWithoutMemory, testing::Values(0, 1, 2, 3));

TEST(PairSet, GivesMemoryBackWhenPairsHaveGone) {
  Pairs many;
  for (BodyId id = 1; id <= 100'000; ++id) many.push_back({0, id});
  for (const bool asked_for : {false, true}) {
    PairSet set;
    update(set, many, {});
    update(set, {{1, 2}}, {});
    if (asked_for) static_cast<void>(set.pairs());
    update(set, {}, many);
    if (asked_for) static_cast<void>(set.pairs());
    for (int quiet = 0; quiet < 3; ++quiet) {
      set.remember_changes();
      set.commit_nothing();
    }
    EXPECT_LE(set.bytes(), std::size_t{512} << 10) << (asked_for ? "asked for" : "not asked for");
    EXPECT_THAT(set.pairs(), ElementsAre(Pair{1, 2}));
  }
}

}  // namespace
}  // namespace cellsweep
