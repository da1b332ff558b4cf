#include "engines/stream/pairs/candidate_list.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/threads/per_worker.h"
#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

/// Leaves out of two ascending lists what is in both.
void cancel_equal(Array<SlotPair>& one, Array<SlotPair>& other) {
  const auto [one_end, other_end] =
      write_changes<SlotPair>(other.view(), one.view(), {}, {one.data(), other.data()});
  one.shrink(static_cast<std::size_t>(one_end - one.data()));
  other.shrink(static_cast<std::size_t>(other_end - other.data()));
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

/// How many of some steps are due with a share, 0 to 1, of all: they begin and end with these.
std::size_t steps_due(double share, double begin, double end, std::size_t steps) {
  const double due = std::clamp((share - begin) / (end - begin), 0.0, 1.0);
  return static_cast<std::size_t>(due * static_cast<double>(steps));
}

}  // namespace

std::span<const SlotPair> CandidateList::pairs(Crew& crew, PairRoom& room) {
  return std::as_const(all(crew, room)).view();
}

Array<SlotPair>& CandidateList::all(Crew& crew, PairRoom& room) {
  sort_found(crew);
  return list_.all(room.one);
}

// Not std::swap, which would make programs half a kilobyte longer.
void CandidateList::swap(CandidateList& other) {
  CandidateList one = std::move(*this);
  *this = std::move(other);
  other = std::move(one);
}

void CandidateList::sort_found(Crew& crew) {
  sort_until(crew, 1);
  if (found_.empty()) return;
  sort_pairs(crew, found_, keys_, list_.pairs());
  found_.clear();
}

void CandidateList::take(Crew& crew, PairRoom& room, Array<SlotPair>& taken) {
  pairs(crew, room);
  std::swap(list_.pairs(), taken);
  list_.pairs().shrink(0);
  size_ = 0;
}

void CandidateList::begin_sort(Crew& crew, Array<SlotPair>& spare) {
  std::swap(list_.pairs(), spare);
  if (!are_sorted_in_parts(size_)) return sort_found(crew);
  list_.pairs().renew(size_);
  keys_.renew(size_);
  buckets_.emplace(crew, found_, tuning::kPartsOfDistribution);
  buckets_sorted_ = 0;
}

bool CandidateList::sort_until(Crew& crew, double share) {
  if (!buckets_) return true;
  constexpr double kDistributed = tuning::kShareOfDistribution;
  buckets_->distribute(crew, steps_due(share, 0, kDistributed, buckets_->parts()), keys_.data());
  if (!buckets_->are_full()) return false;
  const std::span<const std::size_t> begins = buckets_->begins();
  const std::size_t due = steps_due(share, kDistributed, 1, begins.back());
  const auto end = std::lower_bound(begins.begin(), begins.end(), due) - begins.begin();
  if (const auto sorted = static_cast<std::size_t>(end); sorted > buckets_sorted_) {
    sort_buckets(crew, begins, buckets_sorted_, sorted - buckets_sorted_, keys_, list_.pairs());
    buckets_sorted_ = sorted;
  }
  if (begins[buckets_sorted_] < begins.back()) return false;
  buckets_.reset();
  found_.clear();
  return true;
}

void CandidateList::replace(KeyParts found) {
  buckets_.reset();
  found_.assign(found.begin(), found.end());
  list_.forget_notes();
  size_ = count_keys(found);
}

// What was found is not put in order for a few notes.
void CandidateList::begin_notes(Crew& crew, PairRoom& room) {
  if (list_.are_many(list_.notes(), size_)) sort_found(crew);
  if (found_.empty()) {
    list_.go_on(room.one);
  } else {
    list_.keep_notes();
  }
  size_before_ = size_;
}

bool CandidateList::note(std::span<const std::uint64_t> keys, bool are_there) {
  if (list_.new_notes() + keys.size() > size_before_ / 2 + tuning::kManyNotes) return false;
  list_.reserve_notes(keys.size());
  for (const std::uint64_t key : keys) list_.note(key);
  size_ = are_there ? size_ + keys.size() : size_ - keys.size();
  return true;
}

void CandidateList::forget_notes() {
  list_.forget_new_notes();
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
    apply_changes<SlotPair>(crew, list_.pairs().view(), began_.view(), ended_.view(), room.one);
    std::swap(list_.pairs(), room.one);
  }
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

void CandidateList::list_pairs_of(Crew& crew, const std::uint8_t* changed, Array<SlotPair>& listed) const {
  const std::span<const SlotPair> pairs = list_.pairs().view();
  listed.renew(pairs.size());
  PerWorker<std::size_t> counts(crew.active());
  crew.run([&](unsigned worker) {
    const Share share = Share::of(pairs.size(), worker, crew.active());
    SlotPair* const first = listed.data() + share.first;
    const auto mine = pairs.subspan(share.first, share.last - share.first);
    counts[worker] = static_cast<std::size_t>(list_changed(mine, changed, first) - first);
  });
  std::size_t size = counts[0];
  for (unsigned worker = 1; worker < crew.active(); ++worker) {
    const SlotPair* const from = listed.data() + Share::of(pairs.size(), worker, crew.active()).first;
    if (counts[worker] > 0) std::memmove(listed.data() + size, from, counts[worker] * sizeof(SlotPair));
    size += counts[worker];
  }
  listed.shrink(size);
}

// What is noted waits on.
void CandidateList::give_back(Crew& crew) {
  sort_found(crew);
  for (Array<SlotPair>* list : {&began_, &ended_}) *list = {};
  keys_ = {};
  list_.give_back();
}

std::size_t CandidateList::bytes() const {
  return list_.bytes() + began_.bytes() + ended_.bytes() + keys_.bytes() + (buckets_ ? buckets_->bytes() : 0);
}

}  // namespace cellsweep::stream
