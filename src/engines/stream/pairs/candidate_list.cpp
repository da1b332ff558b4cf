#include "engines/stream/pairs/candidate_list.h"

#include <algorithm>
#include <utility>

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

}  // namespace

SlotPairChanges find_changes(std::span<const SlotPair> old, std::span<const SlotPair> now,
                             Array<SlotPair>& began_list, Array<SlotPair>& ended_list) {
  began_list.renew(now.size());
  ended_list.renew(old.size());
  SlotPair* began = began_list.data();
  SlotPair* ended = ended_list.data();
  std::size_t i = 0, j = 0;
  while (i < old.size() && j < now.size()) {
    const std::uint64_t before = pair_key(old[i]);
    const std::uint64_t after = pair_key(now[j]);
    *ended = old[i];
    *began = now[j];
    ended += before < after ? 1 : 0;
    began += after < before ? 1 : 0;
    i += before <= after ? 1 : 0;
    j += after <= before ? 1 : 0;
  }
  ended = std::copy(old.begin() + static_cast<std::ptrdiff_t>(i), old.end(), ended);
  began = std::copy(now.begin() + static_cast<std::ptrdiff_t>(j), now.end(), began);
  began_list.shrink(static_cast<std::size_t>(began - began_list.data()));
  ended_list.shrink(static_cast<std::size_t>(ended - ended_list.data()));
  return {std::as_const(began_list).view(), std::as_const(ended_list).view()};
}

std::span<const SlotPair> CandidateList::pairs(Crew& crew) {
  if (!found_.empty()) {
    sort_pairs(crew, found_, keys_, pairs_);
    found_.clear();
  }
  return std::as_const(pairs_).view();
}

std::size_t CandidateList::size() const {
  if (found_.empty()) return pairs_.size();
  std::size_t sum = 0;
  for (const auto part : found_) sum += part.size();
  return sum;
}

SlotPairChanges CandidateList::change(Crew& crew, KeyParts began, KeyParts ended) {
  pairs(crew);
  sort_pairs(crew, began, keys_, began_);
  sort_pairs(crew, ended, keys_, ended_);
  cancel_equal(began_, ended_);
  if (began_.size() + ended_.size() > 0) apply_changes();
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

// What lies between two changes is copied as a whole.
void CandidateList::apply_changes() {
  const std::span<const SlotPair> began = began_.view();
  const std::span<const SlotPair> ended = ended_.view();
  const std::span<const SlotPair> old = pairs_.view();
  spare_.renew(old.size() + began.size() - ended.size());
  SlotPair* to = spare_.data();
  std::size_t from = 0;
  std::size_t b = 0;
  std::size_t e = 0;
  const auto copy_until = [&](std::uint64_t key) {
    // Changes are many or few: look nearby first.
    std::size_t step = 1;
    while (from + step < old.size() && pair_key(old[from + step]) < key) step *= 2;
    const auto first = old.begin() + static_cast<std::ptrdiff_t>(from);
    const auto last = old.begin() + static_cast<std::ptrdiff_t>(std::min(from + step + 1, old.size()));
    const auto end = std::lower_bound(
        first, last, key, [](const SlotPair& pair, std::uint64_t k) { return pair_key(pair) < k; });
    to = std::copy(first, end, to);
    from = static_cast<std::size_t>(end - old.begin());
  };
  while (b < began.size() || e < ended.size()) {
    const bool is_end = b == began.size() || (e < ended.size() && pair_key(ended[e]) < pair_key(began[b]));
    copy_until(pair_key(is_end ? ended[e] : began[b]));
    if (is_end) {
      ++from;
      ++e;
    } else {
      *to++ = began[b++];
    }
  }
  std::copy(old.begin() + static_cast<std::ptrdiff_t>(from), old.end(), to);
  std::swap(pairs_, spare_);
}

std::size_t CandidateList::bytes() const {
  return pairs_.bytes() + spare_.bytes() + began_.bytes() + ended_.bytes() + keys_.bytes();
}

}  // namespace cellsweep::stream
