#include "broadphase/tree_account.h"

#include <algorithm>

#include "base/tuning.h"

namespace cellsweep {
namespace {

/// Of bringing a tree up to date.
std::uint64_t price_of(std::size_t changes, std::size_t bodies) {
  return changes <= TreeAccount::few_of(bodies) ? tuning::kTreeChangePrice * changes
                                                : tuning::kTreeUpdatePrice * bodies;
}

}  // namespace

std::size_t TreeAccount::few_of(std::size_t bodies) {
  return bodies / tuning::kFewChangesOfTree;
}

[[gnu::cold]] void TreeAccount::made() {
  spent_ = 0;
  was_saved_for_ = saving_ > tuning::kUpdatesToSave;
  saving_ = 0;
}

[[gnu::cold]] void TreeAccount::wears_out() {
  halved_ = was_saved_for_ && !has_paid_off() ? std::min(halved_ + 1, tuning::kMostHalved) : 0;
}

[[gnu::cold]] void TreeAccount::lost() {
  price_.store(make_price_, std::memory_order_relaxed);
  paid_.store(0, std::memory_order_relaxed);
  saved_ = 0;
}

void TreeAccount::begin_update(std::size_t changes, std::size_t bodies, bool had_tree) {
  if (had_tree) {
    saved_ = 0;
  } else {
    save(paid_.load(std::memory_order_relaxed) - saved_);
  }
  saving_ = saved_ > 0 ? saving_ + 1 : 0;
  change_price_ = price_of(changes, bodies);
  make_price_ = tuning::kTreePrice * (bodies + tuning::kFewestPaidFor);
  paid_.store(saved_, std::memory_order_relaxed);
  price_.store(make_price_, std::memory_order_relaxed);
}

// Less than the price of bringing a tree up to date is a loss.
void TreeAccount::save(std::uint64_t paid) {
  if (paid >= change_price_) {
    saved_ += (paid - change_price_) >> halved_;
  } else {
    saved_ -= std::min(saved_, change_price_ - paid);
  }
}

[[gnu::cold]] void TreeAccount::expect_changes(std::size_t changes, std::size_t bodies, bool had_tree) {
  update_price_ = price_of(changes, bodies);
  const std::uint64_t price = had_tree ? update_price_ / tuning::kPartOfPrice : update_price_;
  price_.store(price, std::memory_order_relaxed);
}

}  // namespace cellsweep
