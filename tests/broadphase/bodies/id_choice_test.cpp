/// @file
/// Ids for bodies whose owner has none.
#include "broadphase/bodies/id_choice.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "base/memory/starved.h"
#include "broadphase/bodies/bodies.h"
#include "broadphase/bodies/id_tables.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// A table and who chooses ids for it, told of all that happens.
class IdChoiceTest : public testing::Test {
 protected:
  Ids choose(std::size_t count) {
    Ids ids(count);
    choice_.choose(table_, ids);
    return ids;
  }
  Ids add(std::size_t count) {
    const Ids ids = choose(count);
    insert(table_, ids);
    return ids;
  }
  void insert_given(const Ids& ids) {
    insert(table_, ids);
    choice_.note_other();
  }
  void release() {
    choice_.note_freed();
    table_.release();
  }
  void number_anew() {
    List<Slot> before;
    table_ = table_.renumbered(before);
  }

  IdTable table_;
  IdChoice choice_;
};

TEST_F(IdChoiceTest, IsFromZeroOnInAnEmptyTable) {
  EXPECT_THAT(choose(4), ElementsAre(0U, 1U, 2U, 3U));
  EXPECT_THAT(choose(0), IsEmpty());
}

TEST_F(IdChoiceTest, FillsTheGapsThatBodiesLeft) {
  insert_given({0, 1, 2, 3, 4, 5});
  remove(table_, {1, 4});
  release();
  EXPECT_THAT(choose(3), UnorderedElementsAre(1U, 4U, 6U));
}

TEST_F(IdChoiceTest, LeavesThoseOfBodiesAloneWhosePairsHaveNotEnded) {
  insert_given({0, 1, 2});
  remove(table_, {1});
  EXPECT_THAT(choose(2), UnorderedElementsAre(3U, 4U));
  release();
  EXPECT_THAT(choose(2), UnorderedElementsAre(1U, 3U));
}

TEST_F(IdChoiceTest, IsOfTheNextOnesBehindIdsThatAreTakenUntilSomeOfThoseAreGone) {
  Ids taken;
  for (BodyId id = 100; id < 200; ++id) taken.push_back(id);
  insert_given(taken);
  for (BodyId next = 200; next < 210; ++next) {
    EXPECT_THAT(choose(1), ElementsAre(next)) << "chosen, and not used";
    EXPECT_THAT(choose(1), ElementsAre(next));
    insert(table_, {next});
  }
  remove(table_, {150});
  EXPECT_THAT(choose(2), ElementsAre(210U, 211U));
  release();
  EXPECT_THAT(choose(2), UnorderedElementsAre(50U, 150U)) << "150 is looked at again";
}

TEST_F(IdChoiceTest, IsNobodysAndDiffersThroughRandomCalls) {
  contract::Random random(2);
  std::set<BodyId> held;
  std::set<BodyId> waiting;
  for (int call = 0; call < 1000; ++call) {
    for (const BodyId id : add(random.below(6))) {
      ASSERT_FALSE(waiting.contains(id));
      ASSERT_TRUE(held.insert(id).second);
    }
    if (const BodyId id = random_id(random); held.insert(id).second) insert_given({id});
    for (int i = random.whole(0, 7); i > 0 && !held.empty(); --i) {
      const BodyId id = *std::next(held.begin(), static_cast<std::ptrdiff_t>(random.below(held.size())));
      remove(table_, {id});
      held.erase(id);
      waiting.insert(id);
    }
    if (random.one_in(3)) {
      release();
      waiting.clear();
    }
    ASSERT_EQ(table_.size(), held.size());
  }
}

TEST_F(IdChoiceTest, StaysSmallThroughNumberingAnew) {
  contract::Random random(5);
  Ids held;
  std::set<BodyId> taken;  // by those who are held or wait
  std::size_t most = 0;
  for (int round = 0; round < 400; ++round) {
    const Ids added = add(random.below(round % 7 == 0 ? 2000 : 40));
    most = std::max(most, taken.size() + added.size());
    for (const BodyId id : added) {
      ASSERT_LT(id, most);
      ASSERT_TRUE(taken.insert(id).second) << id << " is taken";
    }
    held.insert(held.end(), added.begin(), added.end());
    // All but a few at times, and those at one end or anywhere.
    const std::size_t left = random.one_in(4) ? random.below(held.size() / 8 + 1) : held.size() / 4 * 3;
    if (random.one_in(2)) std::ranges::sort(held);
    if (random.one_in(2)) std::ranges::reverse(held);
    remove(table_, {held.begin() + static_cast<std::ptrdiff_t>(left), held.end()});
    held.resize(left);
    if (random.one_in(3)) continue;
    release();
    taken = {held.begin(), held.end()};
    if (table_.is_sparse()) number_anew();
  }
}

TEST_F(IdChoiceTest, ChangesNothingWithoutMemory) {
  insert_given({1, 2, 3});
  remove(table_, {2});
  Ids ids(2);
  const auto choose_two = [&](IdChoice& choice) { choice.choose(table_, ids); };
  const auto is_as_ever = [&](IdChoice choice) {
    choice.choose(table_, ids);
    EXPECT_THAT(ids, ElementsAre(5U, 4U));
  };
  EXPECT_EQ(starve([&] { return choice_; }, choose_two, is_as_ever, is_as_ever), 1U);
}

/// The bodies of a broadphase, most of whom leave, so that slots are numbered anew.
class AddedBodies : public testing::Test {
 protected:
  static constexpr std::size_t kMany = 1500;

  Ids add(std::size_t count) {
    Ids ids(count);
    EXPECT_TRUE(bodies_.add(crew_, std::vector<Aabb>(count), ids, "stream", {1'000'000, "", ""}).ok());
    return ids;
  }
  void insert(BodyId id) {
    const Aabb box{};
    EXPECT_TRUE(bodies_.insert(crew_, {&id, 1}, {&box, 1}, {}, "stream", {1'000'000, "", ""}).ok());
  }
  void update() {
    bodies_.begin_update();
    bodies_.commit();
  }
  void leave_the_last(std::size_t count) {
    Ids gone;
    for (Slot slot = 0; slot + count < bodies_.table().slot_count(); ++slot)
      gone.push_back(bodies_.table().id(slot));
    EXPECT_TRUE(bodies_.remove(gone).ok());
    update();
    EXPECT_TRUE(bodies_.tidy());
  }

  // Some behind all slots, and no two the same.
  void expect_some_behind(Ids ids) {
    std::ranges::sort(ids);
    EXPECT_GE(ids.back(), bodies_.table().slot_count());
    EXPECT_EQ(std::ranges::adjacent_find(ids), ids.end());
  }

  Crew crew_{nullptr, 1, Crew::Choice::given};
  Bodies bodies_;
};

// The hundred that are left have the largest ids and the smallest slots: a chosen id is one of a slot.
TEST_F(AddedBodies, HaveIdsBelowTheMostThereWereWhereAllWereAdded) {
  add(kMany);
  update();
  leave_the_last(100);
  for (const BodyId id : add(kMany - 100)) EXPECT_LT(id, kMany);
}

// There the way to a small id may be long: those that are in doubt lie behind all others.
TEST_F(AddedBodies, HaveIdsThatNobodyHasWhereOthersWereGiven) {
  add(kMany);
  insert(kMany);
  update();
  leave_the_last(100);
  expect_some_behind(add(kMany));
}

TEST_F(AddedBodies, HaveIdsThatNobodyHasWhereFiltersChanged) {
  Ids ids = add(kMany);
  update();
  ids.resize(10);
  const std::vector<BodyFilter> filters(ids.size(), BodyFilter{.category = 2});
  EXPECT_TRUE(bodies_.set_filters(ids, filters).ok());
  update();
  leave_the_last(100);
  expect_some_behind(add(kMany));
}

TEST_F(AddedBodies, HaveIdsAgainThatWereTaken) {
  for (BodyId id = 100; id < 200; ++id) insert(id);
  add(10);
  update();
  EXPECT_TRUE(bodies_.remove(Ids{150}).ok());
  update();
  EXPECT_THAT(add(2), UnorderedElementsAre(50U, 150U));
}

TEST_F(AddedBodies, AreTheFirstWhenNobodyIsLeft) {
  insert(7);
  update();
  EXPECT_TRUE(bodies_.remove(Ids{7}).ok());
  update();
  add(kMany);
  update();
  leave_the_last(100);
  for (const BodyId id : add(kMany - 100)) EXPECT_LT(id, kMany);
}

}  // namespace
}  // namespace cellsweep
