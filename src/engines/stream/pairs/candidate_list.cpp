#include "engines/stream/pairs/candidate_list.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/per_worker.h"
#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

/// Leaves out of two ascending lists what is in both.
void cancel_equal(Array<SlotPair>& one, Array<SlotPair>& other) {
  std::size_t i = 0, j = 0, i_kept = 0, j_kept = 0;
  SlotPair* a = one.data();
  SlotPair* b = other.data();
  while (i < one.size() && j < other.size()) {
    const std::uint64_t key_a = pair_key(a[i]);
    const std::uint64_t key_b = pair_key(b[j]);
    if (key_a == key_b) {
      ++i, ++j;
    } else if (key_a < key_b) {
      a[i_kept++] = a[i++];
    } else {
      b[j_kept++] = b[j++];
    }
  }
  while (i < one.size()) a[i_kept++] = a[i++];
  while (j < other.size()) b[j_kept++] = b[j++];
  one.shrink(i_kept);
  other.shrink(j_kept);
}

/// Writes the pairs of changed slots to a list and returns its end. Which these are nobody can foretell, but
/// mostly there are none among the next few: there is no branch on one alone.
SlotPair* list_changed(std::span<const SlotPair> pairs, const std::uint8_t* changed, SlotPair* to) {
  constexpr std::size_t kFew = 8;
  const auto is_changed = [=](const SlotPair& pair) { return changed[pair.a] | changed[pair.b]; };
  const auto list = [&](std::span<const SlotPair> some) {
    for (const SlotPair& pair : some) {
      *to = pair;
      to += is_changed(pair) != 0 ? 1 : 0;
    }
  };
  std::size_t i = 0;
  for (; i + kFew <= pairs.size(); i += kFew) {
    int any = 0;
    for (std::size_t k = 0; k < kFew; ++k) any |= is_changed(pairs[i + k]);
    if (any != 0) list(pairs.subspan(i, kFew));
  }
  list(pairs.subspan(i));
  return to;
}

}  // namespace

std::span<const SlotPair> CandidateList::pairs(Crew& crew, PairRoom& room) {
  sort_found(crew);
  if (!notes_.empty()) {
    apply_notes<SlotPair>(pairs_.view(), notes_.view(), room.one);
    std::swap(pairs_, room.one);
    notes_.clear();
  }
  return std::as_const(pairs_).view();
}

void CandidateList::sort_found(Crew& crew) {
  sort_until(crew, 1);
  if (found_.empty()) return;
  sort_pairs(crew, found_, keys_, pairs_);
  found_.clear();
}

void CandidateList::take(Crew& crew, PairRoom& room, Array<SlotPair>& taken) {
  pairs(crew, room);
  std::swap(pairs_, taken);
  pairs_.shrink(0);
  size_ = 0;
}

void CandidateList::begin_sort(Crew& crew, Array<SlotPair>& spare) {
  std::swap(pairs_, spare);
  if (!are_sorted_in_parts(size_)) return sort_found(crew);
  pairs_.renew(size_);
  buckets_ = distribute_pairs(crew, found_, keys_);
  buckets_sorted_ = 0;
  found_.clear();
}

bool CandidateList::sort_until(Crew& crew, double share) {
  if (buckets_.empty()) return true;
  const std::size_t all = buckets_.size() - 1;
  const auto due = static_cast<std::size_t>(share * static_cast<double>(all));
  if (due > buckets_sorted_) {
    sort_buckets(crew, buckets_, buckets_sorted_, due - buckets_sorted_, keys_, pairs_);
    buckets_sorted_ = due;
  }
  if (buckets_sorted_ == all) buckets_.clear();
  return buckets_.empty();
}

void CandidateList::replace(KeyParts found) {
  buckets_.clear();
  found_.assign(found.begin(), found.end());
  notes_.clear();
  size_ = count_keys(found);
}

void CandidateList::begin_notes(Crew& crew, PairRoom& room) {
  if (notes_.size() > size_ / 4 + tuning::kFewNotes) pairs(crew, room);
  notes_before_ = notes_.size();
  size_before_ = size_;
}

bool CandidateList::note(std::span<const std::uint64_t> keys, bool are_there) {
  const std::size_t size = notes_.size() + keys.size();
  if (size - notes_before_ > size_before_ / 2 + tuning::kManyNotes) return false;
  notes_.reserve(size);
  for (const std::uint64_t key : keys) notes_.push({key, are_there});
  size_ = are_there ? size_ + keys.size() : size_ - keys.size();
  return true;
}

void CandidateList::forget_notes() {
  notes_.set_size(notes_before_);
  size_ = size_before_;
}

SlotPairChanges CandidateList::change(Crew& crew, PairRoom& room, KeyParts touched,
                                      const std::uint8_t* changed) {
  pairs(crew, room);
  sort_pairs(crew, touched, keys_, began_);
  list_pairs_of(crew, changed, room.one);
  cancel_equal(began_, room.one);
  ended_.renew(room.one.size());
  std::copy_n(room.one.data(), room.one.size(), ended_.data());
  size_ = size_ + began_.size() - ended_.size();
  if (began_.size() + ended_.size() > 0) {
    apply_changes<SlotPair>(crew, pairs_.view(), began_.view(), ended_.view(), room.one);
    std::swap(pairs_, room.one);
  }
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

void CandidateList::list_pairs_of(Crew& crew, const std::uint8_t* changed, Array<SlotPair>& listed) const {
  listed.renew(pairs_.size());
  PerWorker<std::size_t> counts(crew.active());
  crew.run([&](unsigned worker) {
    const Share share = Share::of(pairs_.size(), worker, crew.active());
    SlotPair* const first = listed.data() + share.first;
    const auto mine = std::as_const(pairs_).view().subspan(share.first, share.last - share.first);
    counts[worker] = static_cast<std::size_t>(list_changed(mine, changed, first) - first);
  });
  std::size_t size = counts[0];
  for (unsigned worker = 1; worker < crew.active(); ++worker) {
    const SlotPair* const from = listed.data() + Share::of(pairs_.size(), worker, crew.active()).first;
    if (counts[worker] > 0) std::memmove(listed.data() + size, from, counts[worker] * sizeof(SlotPair));
    size += counts[worker];
  }
  listed.shrink(size);
}

void CandidateList::give_back(Crew& crew, PairRoom& room) {
  pairs(crew, room);
  for (Array<SlotPair>* list : {&began_, &ended_}) *list = {};
  keys_ = {};
  notes_ = {};
  pairs_.fit();
}

std::size_t CandidateList::bytes() const {
  return pairs_.bytes() + began_.bytes() + ended_.bytes() + keys_.bytes() + notes_.bytes() +
         buckets_.capacity() * sizeof(std::size_t);
}

}  // namespace cellsweep::stream
