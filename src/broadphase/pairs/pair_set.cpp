#include "broadphase/pairs/pair_set.h"

#include <utility>

#include "base/key_sort.h"
#include "base/tuning.h"

namespace cellsweep {

void PairSet::give_back_room() {
  constexpr std::size_t kKept = std::size_t{64} << 10;
  const std::size_t pairs = pairs_.size() + began_.size() + ended_.size();
  const std::size_t enough = 4 * pairs * sizeof(Pair) + kKept;
  for (Array<Pair>* list : {&next_began_, &next_ended_, &whole_, &spare_}) {
    if (list->bytes() > enough) *list = Array<Pair>();
  }
  for (Array<Pair>* list : {&began_, &ended_}) {
    if (list->size() == 0 && list->bytes() > enough) *list = Array<Pair>();
  }
  if (notes_.empty() && notes_.bytes() > enough) notes_ = {};
  pairs_.fit();
}

void PairSet::remember_changes() {
  give_back_room();
  if (!listing_.waits()) return;
  if (std::exchange(only_began_, false)) {
    std::swap(pairs_, began_);  // there were none
    listing_.put_off(false);
    return;
  }
  const std::size_t notes = notes_.size() + began_.size() + ended_.size();
  if (notes > pairs_.size() / 4 + tuning::kFewNotes) {
    listing_.finish([&] { list_all(); });
    return;
  }
  note_changes();
  began_.shrink(0);
  ended_.shrink(0);
}

// A pair that is in both lists ended with one body and began with another of the same id: it is noted twice,
// and there as before.
void PairSet::note_changes() const {
  notes_.reserve(notes_.size() + began_.size() + ended_.size());
  for (const Pair& pair : ended_.view()) notes_.push(pair_key(pair));
  for (const Pair& pair : began_.view()) notes_.push(pair_key(pair));
}

// What was noted once must not be noted again: after that nothing may throw.
void PairSet::list_noted() const {
  const std::size_t notes = notes_.size() + began_.size() + ended_.size();
  Array<std::uint64_t> sorted;
  sorted.renew(notes);
  spare_.renew(pairs_.size() + notes);
  note_changes();
  apply_alternating<Pair>(pairs_.view(), sort_keys(notes_.view(), sorted.view()), spare_);
  notes_.clear();
}

void PairSet::compare_with_whole_set(std::span<const BodyId> gone) {
  std::swap(whole_, next_began_);
  find_changes<Pair>(pairs(), whole_.view(), gone, next_began_, next_ended_);
}

void PairSet::commit() {
  std::swap(began_, next_began_);
  std::swap(ended_, next_ended_);
  only_began_ = pairs_.size() == 0 && notes_.empty() && ended_.size() == 0;
  if (began_.size() + ended_.size() > 0) listing_.put_off();
}

void PairSet::commit_nothing() {
  began_.shrink(0);
  ended_.shrink(0);
}

std::span<const Pair> PairSet::pairs() const {
  if (only_began_ && listing_.waits()) return std::as_const(began_).view();
  listing_.finish([&] { list_all(); });
  return std::as_const(pairs_).view();
}

void PairSet::list_all() const {
  if (notes_.empty()) {
    apply_changes<Pair>(pairs_.view(), began_.view(), ended_.view(), spare_);
  } else {
    list_noted();
  }
  std::swap(pairs_, spare_);
}

std::size_t PairSet::bytes() const {
  std::size_t sum = notes_.bytes();
  for (const Array<Pair>* list : {&began_, &ended_, &next_began_, &next_ended_, &whole_})
    sum += list->bytes();
  return sum + pairs_.bytes() + spare_.bytes();
}

}  // namespace cellsweep
