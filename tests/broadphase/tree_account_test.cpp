/// @file
/// When questions have paid for a tree: of one update alone, or saved over many.
#include "broadphase/tree_account.h"

#include <gtest/gtest.h>

#include "base/tuning.h"

namespace cellsweep {
namespace {

constexpr std::size_t kBodies = 1000;
constexpr std::uint64_t kPrice = tuning::kTreePrice * (kBodies + tuning::kFewestPaidFor);

/// Updates in which one body changes and questions pay a 64th of a tree, until there is one.
int updates_to_save(TreeAccount& account) {
  for (int updates = 1; updates < 10000; ++updates) {
    account.begin_update(1, kBodies, false);
    if (account.pay(kPrice / 64)) return updates;
  }
  return 0;
}

/// A tree that was saved for wears out before it has paid off.
void save_for_one_that_wears_out(TreeAccount& account) {
  ASSERT_GT(updates_to_save(account), 0);
  account.made();
  account.wears_out();
  account.lost();
}

TEST(TreeAccount, IsPaidByTheQuestionsOfOneUpdateOrOverMany) {
  TreeAccount account;
  account.begin_update(kBodies, kBodies, false);
  EXPECT_FALSE(account.pay(kPrice - 1));
  EXPECT_TRUE(account.pay(1));
  account.lost();
  const int updates = updates_to_save(account);
  EXPECT_GE(updates, 64);
  EXPECT_LT(updates, 70);
}

TEST(TreeAccount, SavesNothingWhereATreeWouldTakeLongerToBringUpToDate) {
  TreeAccount account;
  for (int i = 0; i < 10000; ++i) {
    account.begin_update(kBodies, kBodies, false);
    ASSERT_FALSE(account.pay(tuning::kTreeUpdatePrice * kBodies));
  }
}

TEST(TreeAccount, SavesLessAfterOneThatDidNotPayOffButOneUpdatesQuestionsCountAsBefore) {
  TreeAccount account;
  for (int i = 0; i < 20; ++i) save_for_one_that_wears_out(account);
  account.begin_update(1, kBodies, false);
  EXPECT_FALSE(account.pay(kPrice - 1));
  EXPECT_TRUE(account.pay(1)) << "whatever was saved for in vain before";
  account.lost();
  EXPECT_GT(updates_to_save(account), 1000);
}

TEST(TreeAccount, SavesAsBeforeOnceATreeHasPaidOff) {
  TreeAccount account;
  for (int i = 0; i < 3; ++i) save_for_one_that_wears_out(account);
  ASSERT_GT(updates_to_save(account), 70);
  account.made();
  while (!account.has_paid_off()) {
    account.begin_update(kBodies, kBodies, true);
    account.expect_changes(kBodies, kBodies, true);
    account.brought_up_to_date();
  }
  account.wears_out();
  account.lost();
  EXPECT_LT(updates_to_save(account), 70);
}

}  // namespace
}  // namespace cellsweep
