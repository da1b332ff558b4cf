#include "broadphase/pairs/pair_filter.h"

#include <algorithm>
#include <utility>

#include "base/key_sort.h"
#include "base/pair_of.h"
#include "base/pair_sort.h"

namespace cellsweep {
namespace {

bool may_pair_slots(const SlotFilters& filters, Slot one, Slot other) {
  return may_pair(filters.of(one), filters.of(other));
}

/// Where the bodies of slots are now.
class SlotsNow {
 public:
  explicit SlotsNow(std::span<const SlotFilters::Move> moves) : moves_(moves.begin(), moves.end()) {
    std::ranges::sort(moves_, {}, &SlotFilters::Move::from);
  }

  Slot operator()(Slot slot) const {
    const auto found = std::ranges::lower_bound(moves_, slot, {}, &SlotFilters::Move::from);
    return found != moves_.end() && found->from == slot ? found->to : slot;
  }

 private:
  std::vector<SlotFilters::Move> moves_;
};

}  // namespace

FoundPairs PairFilter::apply(const FoundPairs& found, const SlotFilters& filters) {
  const bool some_moved = !filters.moves().empty() && !found.is_whole_set;
  if (found.is_filtered && !some_moved) return found;
  allow(found.began, filters, began_);
  allow(found.ended, filters, ended_);
  allow_keys(found.more_began, filters);
  if (some_moved) cancel(filters);
  more_view_ = std::as_const(more_began_).view();
  FoundPairs allowed{std::as_const(began_).view(), std::as_const(ended_).view(), {}, found.is_whole_set};
  if (!more_view_.empty()) allowed.more_began = {&more_view_, 1};
  return allowed;
}

void PairFilter::allow(std::span<const SlotPair> pairs, const SlotFilters& filters,
                       Array<SlotPair>& allowed) {
  allowed.renew(pairs.size());
  SlotPair* to = allowed.data();
  for (const SlotPair& pair : pairs) {
    *to = pair;
    to += may_pair_slots(filters, pair.a, pair.b) ? 1 : 0;
  }
  allowed.shrink(static_cast<std::size_t>(to - allowed.data()));
}

void PairFilter::allow_keys(KeyParts parts, const SlotFilters& filters) {
  more_began_.clear();
  more_began_.reserve(count_keys(parts) + began_.size());
  for (const auto part : parts) {
    for (const std::uint64_t key : part) {
      if (may_pair_slots(filters, static_cast<Slot>(key >> 32), static_cast<Slot>(key)))
        more_began_.push(key);
    }
  }
}

// Both lists by the slots that bodies have now, side by side.
void PairFilter::cancel(const SlotFilters& filters) {
  for (const SlotPair& pair : began_.view()) more_began_.push(pair_key(pair));
  began_.shrink(0);
  sort_keys(more_began_.view());
  list_ended_now(filters);
  std::size_t began = 0, ended = 0;
  std::size_t i = 0;
  for (const Ended& pair : std::as_const(ended_now_).view()) {
    while (i < more_began_.size() && more_began_[i] < pair.key_now) more_began_[began++] = more_began_[i++];
    if (i < more_began_.size() && more_began_[i] == pair.key_now) {
      ++i;
    } else {
      ended_.data()[ended++] = pair.pair;
    }
  }
  while (i < more_began_.size()) more_began_[began++] = more_began_[i++];
  more_began_.set_size(began);
  ended_.shrink(ended);
  std::ranges::sort(ended_.view());
}

void PairFilter::list_ended_now(const SlotFilters& filters) {
  const SlotsNow now(filters.moves());
  ended_now_.clear();
  ended_now_.reserve(ended_.size());
  for (const SlotPair& pair : std::as_const(ended_).view())
    ended_now_.push({pair_key(make_slot_pair(now(pair.a), now(pair.b))), pair});
  std::ranges::sort(ended_now_.view(), {}, &Ended::key_now);
}

std::size_t PairFilter::bytes() const {
  return began_.bytes() + ended_.bytes() + more_began_.bytes() + ended_now_.bytes();
}

}  // namespace cellsweep
