#include "broadphase/pairs/pair_filter.h"

#include <algorithm>
#include <utility>

#include "base/pairs/pair_of.h"
#include "base/sorting/key_sort.h"
#include "base/sorting/pair_sort.h"

namespace cellsweep {
namespace {

bool may_pair_slots(const SlotFilters& filters, Slot one, Slot other) {
  return may_pair(filters.of(one), filters.of(other));
}

/// Where the bodies of slots are now.
class SlotsNow {
 public:
  explicit SlotsNow(std::span<const SlotFilters::Move> moves) {
    for (const SlotFilters::Move& move : moves) moves_.push_back(key_of(move.from) | move.to);
    sort_keys(moves_);
  }

  Slot operator()(Slot slot) const {
    const auto found = std::ranges::lower_bound(moves_, key_of(slot));
    return found != moves_.end() && *found >> 32 == slot ? static_cast<Slot>(*found) : slot;
  }

 private:
  static std::uint64_t key_of(Slot from) { return std::uint64_t{from} << 32; }

  std::vector<std::uint64_t> moves_;  // from above to, ascending
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

// By the slots that bodies have now.
void PairFilter::cancel(const SlotFilters& filters) {
  for (const SlotPair& pair : began_.view()) more_began_.push(pair_key(pair));
  began_.shrink(0);
  sort_keys(more_began_.view());
  const SlotsNow now(filters.moves());
  cancelled_.clear();
  cancelled_.reserve(ended_.size());
  SlotPair* to = ended_.data();
  for (const SlotPair pair : std::as_const(ended_).view()) {
    const std::uint64_t key = pair_key(make_slot_pair(now(pair.a), now(pair.b)));
    if (std::ranges::binary_search(more_began_.view(), key)) {
      cancelled_.push(key);
    } else {
      *to++ = pair;
    }
  }
  ended_.shrink(static_cast<std::size_t>(to - ended_.data()));
  leave_out_cancelled();
}

void PairFilter::leave_out_cancelled() {
  sort_keys(cancelled_.view());
  std::size_t began = 0;
  std::size_t cancelled = 0;
  for (const std::uint64_t key : std::as_const(more_began_).view()) {
    if (cancelled < cancelled_.size() && cancelled_[cancelled] == key) {
      ++cancelled;
    } else {
      more_began_[began++] = key;
    }
  }
  more_began_.set_size(began);
}

std::size_t PairFilter::bytes() const {
  return began_.bytes() + ended_.bytes() + more_began_.bytes() + cancelled_.bytes();
}

}  // namespace cellsweep
