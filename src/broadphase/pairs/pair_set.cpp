#include "broadphase/pairs/pair_set.h"

#include <utility>

#include "base/pairs/pair_changes.h"

namespace cellsweep {

// Of lists with more bytes than are enough.
void PairSet::give_back_room(std::size_t enough) {
  for (Array<Pair>* list : {&next_began_, &next_ended_, &whole_, &spare_}) {
    if (list->bytes() > enough) *list = Array<Pair>();
  }
  for (Array<Pair>* list : {&began_, &ended_}) {
    if (list->size() == 0 && list->bytes() > enough) *list = Array<Pair>();
  }
  if (list_.bytes() > enough) list_.give_back();
}

void PairSet::remember_changes() {
  constexpr std::size_t kKept = std::size_t{64} << 10;
  const std::size_t pairs = list_.pairs().size() + began_.size() + ended_.size();
  give_back_room(4 * pairs * sizeof(Pair) + kKept);
  if (!listing_.waits()) return;
  if (std::exchange(only_began_, false)) {
    std::swap(list_.pairs(), began_);  // there were none
    listing_.put_off(false);
    return;
  }
  // Many, and in order, they need not be sorted with others later.
  if (list_.is_up_to_date() && list_.are_many(began_.size() + ended_.size(), list_.pairs().size())) {
    listing_.finish([&] { list_all(); });
    return;
  }
  note_changes();
  began_.shrink(0);
  ended_.shrink(0);
  list_.go_on(spare_);
}

// A pair that is in both lists ended with one body and began with another of the same id: it is noted twice,
// and there as before. What an attempt noted that found no memory then is not noted again.
void PairSet::note_changes() const {
  list_.forget_new_notes();
  list_.reserve_notes(began_.size() + ended_.size());
  for (const Pair& pair : ended_.view()) list_.note(pair_key(pair));
  for (const Pair& pair : began_.view()) list_.note(pair_key(pair));
}

void PairSet::compare_with_whole_set(std::span<const BodyId> gone) {
  std::swap(whole_, next_began_);
  find_changes<Pair>(pairs(), whole_.view(), gone, next_began_, next_ended_);
}

void PairSet::commit() {
  std::swap(began_, next_began_);
  std::swap(ended_, next_ended_);
  only_began_ = list_.pairs().size() == 0 && list_.is_up_to_date() && ended_.size() == 0;
  if (began_.size() + ended_.size() > 0) listing_.put_off();
}

void PairSet::commit_nothing() {
  began_.shrink(0);
  ended_.shrink(0);
  list_.go_on_at_rest(spare_);
}

std::span<const Pair> PairSet::pairs() const {
  if (only_began_ && listing_.waits()) return std::as_const(began_).view();
  listing_.finish([&] { list_all(); });
  return std::as_const(list_.pairs()).view();
}

void PairSet::list_all() const {
  if (list_.is_up_to_date()) {
    apply_changes<Pair>(list_.pairs().view(), began_.view(), ended_.view(), spare_);
    std::swap(list_.pairs(), spare_);
    return;
  }
  note_changes();
  list_.all(spare_);
}

std::size_t PairSet::bytes() const {
  std::size_t sum = 0;
  listing_.while_nobody([&] { sum = list_.bytes() + spare_.bytes(); });
  for (const Array<Pair>* list : {&began_, &ended_, &next_began_, &next_ended_, &whole_})
    sum += list->bytes();
  return sum;
}

}  // namespace cellsweep
