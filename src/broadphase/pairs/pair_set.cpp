#include "broadphase/pairs/pair_set.h"

#include <algorithm>
#include <utility>

namespace cellsweep {
namespace {

/// So many changes are remembered whatever the number of pairs.
constexpr std::size_t kFewNotes = 4096;

Pair pair_of(std::uint64_t key) {
  return {static_cast<BodyId>(key >> 32), static_cast<BodyId>(key)};
}

/// Copies a list from place to place: what lies between two changes goes as a whole.
class RunCopy {
 public:
  RunCopy(std::span<const Pair> from, Pair* to) : from_(from), to_(to) {}

  /// All that is below the key.
  void until(std::uint64_t key) {
    // Changes are many or few: look nearby first.
    std::size_t step = 1;
    while (step < from_.size() && pair_key(from_[step]) < key) step *= 2;
    const auto last = from_.begin() + static_cast<std::ptrdiff_t>(std::min(step + 1, from_.size()));
    const auto end = std::lower_bound(from_.begin(), last, key,
                                      [](const Pair& pair, std::uint64_t k) { return pair_key(pair) < k; });
    to_ = std::copy(from_.begin(), end, to_);
    from_ = from_.subspan(static_cast<std::size_t>(end - from_.begin()));
  }
  void leave_out(std::uint64_t key) {
    if (!from_.empty() && pair_key(from_[0]) == key) from_ = from_.subspan(1);
  }
  void put(const Pair& pair) { *to_++ = pair; }

  /// Copies the rest and returns the end of all.
  Pair* finish() { return std::copy(from_.begin(), from_.end(), to_); }

 private:
  std::span<const Pair> from_;
  Pair* to_;
};

}  // namespace

void find_changes(std::span<const Pair> old, std::span<const Pair> now, std::span<const BodyId> gone,
                  Array<Pair>& began_list, Array<Pair>& ended_list) {
  const auto is_gone = [&](BodyId id) { return std::binary_search(gone.begin(), gone.end(), id); };
  began_list.renew(now.size());
  ended_list.renew(old.size());
  Pair* began = began_list.data();
  Pair* ended = ended_list.data();
  std::size_t i = 0, j = 0;
  while (i < old.size() && j < now.size()) {
    const std::uint64_t before = pair_key(old[i]);
    const std::uint64_t after = pair_key(now[j]);
    *ended = old[i];
    *began = now[j];
    const bool other = before == after && !gone.empty() && (is_gone(old[i].a) || is_gone(old[i].b));
    ended += before < after || other ? 1 : 0;
    began += after < before || other ? 1 : 0;
    i += before <= after ? 1 : 0;
    j += after <= before ? 1 : 0;
  }
  ended = std::copy(old.begin() + static_cast<std::ptrdiff_t>(i), old.end(), ended);
  began = std::copy(now.begin() + static_cast<std::ptrdiff_t>(j), now.end(), began);
  began_list.shrink(static_cast<std::size_t>(began - began_list.data()));
  ended_list.shrink(static_cast<std::size_t>(ended - ended_list.data()));
}

// Then the list of all is the list of those that began, and nothing need be copied.
bool PairSet::only_began() const {
  return pairs_.size() == 0 && notes_.empty() && ended_.size() == 0;
}

void PairSet::remember_changes() {
  if (is_listed_.load(std::memory_order_relaxed)) return;
  if (only_began()) {
    std::swap(pairs_, began_);
    began_.shrink(0);
    is_listed_.store(true, std::memory_order_relaxed);
    return;
  }
  const std::size_t notes = notes_.size() + began_.size() + ended_.size();
  if (notes > pairs_.size() / 4 + kFewNotes) {
    list_all();
    return;
  }
  note_changes();
  began_.shrink(0);
  ended_.shrink(0);
}

// A pair that is in both lists ended with one body and began with another of the same id.
void PairSet::note_changes() const {
  notes_.reserve(notes_.size() + began_.size() + ended_.size());
  for (const Pair& pair : ended_.view()) notes_.push({pair_key(pair), false});
  for (const Pair& pair : began_.view()) notes_.push({pair_key(pair), true});
}

void PairSet::compare_with_whole_set(std::span<const BodyId> gone) {
  std::swap(whole_, next_began_);
  find_changes(pairs(), whole_.view(), gone, next_began_, next_ended_);
}

PairChanges PairSet::commit() {
  std::swap(began_, next_began_);
  std::swap(ended_, next_ended_);
  if (began_.size() + ended_.size() > 0) is_listed_.store(false, std::memory_order_relaxed);
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

PairChanges PairSet::commit_nothing() {
  began_.shrink(0);
  ended_.shrink(0);
  return {};
}

std::span<const Pair> PairSet::pairs() const {
  if (!is_listed_.load(std::memory_order_acquire)) {
    const std::lock_guard lock(mutex_);
    if (only_began()) return std::as_const(began_).view();
    if (!is_listed_.load(std::memory_order_relaxed)) list_all();
  }
  return std::as_const(pairs_).view();
}

void PairSet::list_all() const {
  if (notes_.empty()) {
    merge(began_.view(), ended_.view());
  } else {
    note_changes();
    merge_notes();
  }
  is_listed_.store(true, std::memory_order_release);
}

void PairSet::merge(std::span<const Pair> began, std::span<const Pair> ended) const {
  spare_.renew(pairs_.size() + began.size());
  RunCopy copy(std::as_const(pairs_).view(), spare_.data());
  while (!began.empty() || !ended.empty()) {
    const bool is_end = began.empty() || (!ended.empty() && pair_key(ended[0]) <= pair_key(began[0]));
    const Pair pair = is_end ? ended[0] : began[0];
    copy.until(pair_key(pair));
    if (is_end) {
      copy.leave_out(pair_key(pair));
      ended = ended.subspan(1);
    } else {
      copy.put(pair);
      began = began.subspan(1);
    }
  }
  spare_.shrink(static_cast<std::size_t>(copy.finish() - spare_.data()));
  std::swap(pairs_, spare_);
}

void PairSet::merge_notes() const {
  const std::span<Note> notes = notes_.view();
  std::stable_sort(notes.begin(), notes.end(),
                   [](const Note& one, const Note& other) { return one.key < other.key; });
  spare_.renew(pairs_.size() + notes.size());
  RunCopy copy(std::as_const(pairs_).view(), spare_.data());
  for (std::size_t i = 0; i < notes.size(); ++i) {
    const bool is_last = i + 1 == notes.size() || notes[i + 1].key != notes[i].key;
    if (!is_last) continue;
    copy.until(notes[i].key);
    copy.leave_out(notes[i].key);
    if (notes[i].overlapping) copy.put(pair_of(notes[i].key));
  }
  spare_.shrink(static_cast<std::size_t>(copy.finish() - spare_.data()));
  std::swap(pairs_, spare_);
  notes_.clear();
}

std::size_t PairSet::bytes() const {
  std::size_t sum = notes_.bytes();
  for (const Array<Pair>* list : {&began_, &ended_, &next_began_, &next_ended_, &whole_})
    sum += list->bytes();
  return sum + pairs_.bytes() + spare_.bytes();
}

}  // namespace cellsweep
