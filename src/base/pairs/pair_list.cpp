#include "base/pairs/pair_list.h"

#include <limits>
#include <utility>

#include "base/sorting/key_sort.h"
#include "base/tuning.h"

namespace cellsweep {

template <class AnyPair>
Array<AnyPair>& PairList<AnyPair>::all(Array<AnyPair>& spare) {
  if (stage_ != Stage::none) merge(std::numeric_limits<std::size_t>::max(), spare);
  if (!notes_.empty()) list_noted(spare);
  return pairs_;
}

template <class AnyPair>
void PairList<AnyPair>::list_noted(Array<AnyPair>& spare) {
  Array<std::uint64_t> sorted;
  sorted.renew(notes_.size());
  spare.renew(pairs_.size() + notes_.size());
  apply_alternating<AnyPair>(pairs_.view(), sort_keys(notes_.view(), sorted.view()), spare);
  std::swap(pairs_, spare);
  notes_.clear();
  kept_ = 0;
}

template <class AnyPair>
void PairList<AnyPair>::forget_notes() {
  notes_.clear();
  kept_ = 0;
  stage_ = Stage::none;
}

template <class AnyPair>
bool PairList<AnyPair>::are_many(std::size_t notes, std::size_t pairs) {
  return notes > pairs / tuning::kPairsOfNote + tuning::kFewNotes;
}

template <class AnyPair>
void PairList<AnyPair>::go_on(Array<AnyPair>& spare) {
  const std::size_t steps = new_notes() * tuning::kStepsOfNote;
  keep_notes();
  if (stage_ == Stage::none) {
    if (!are_many(notes_.size(), pairs_.size())) return;
    if (pairs_.size() + notes_.size() <= tuning::kListedAtOnce) return list_noted(spare);
    begin_merge(spare);
  }
  merge(steps, spare);
}

template <class AnyPair>
void PairList<AnyPair>::go_on_at_rest(Array<AnyPair>& spare) {
  if (stage_ == Stage::none) return;
  constexpr std::size_t kStepsOfKey = 8;  // seven of the sort, and the merge
  const std::size_t steps = pairs_.size() + kStepsOfKey * sort_.keys().size();
  merge(steps / tuning::kPartsAtRest + 1, spare);
}

template <class AnyPair>
void PairList<AnyPair>::begin_merge(Array<AnyPair>& spare) {
  const std::size_t most = pairs_.size() + notes_.size();
  std::swap(next_, spare);
  next_.renew(most);
  sort_.begin(notes_);
  kept_ = 0;
  stage_ = Stage::sorting;
}

template <class AnyPair>
void PairList<AnyPair>::merge(std::size_t steps, Array<AnyPair>& spare) {
  if (stage_ == Stage::sorting) {
    if (!sort_.go_on(steps)) return;
    stage_ = Stage::merging;
    merge_ = {std::as_const(pairs_).view(), sort_.keys(), next_.data()};
  }
  if (!merge_.go_on(steps)) return;
  next_.shrink(static_cast<std::size_t>(merge_.end() - next_.data()));
  std::swap(pairs_, next_);
  std::swap(next_, spare);
  stage_ = Stage::none;
}

template <class AnyPair>
void PairList<AnyPair>::give_back() {
  if (stage_ != Stage::none) return;
  next_ = {};
  sort_.give_back();
  if (notes_.empty()) notes_ = {};
  pairs_.fit();
}

template class PairList<Pair>;
template class PairList<SlotPair>;

}  // namespace cellsweep
