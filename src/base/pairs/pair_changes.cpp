#include "base/pairs/pair_changes.h"

#include <algorithm>

#include "base/pairs/pair_of.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

/// Copies a list from place to place.
template <class AnyPair>
class RunCopy {
 public:
  RunCopy(std::span<const AnyPair> from, AnyPair* to) : from_(from), to_(to) {}

  /// All that is below the key.
  void until(std::uint64_t key) {
    // Changes are many or few: most runs are short.
    std::size_t blocks = 0;
    while (from_.size() > tuning::kCopied && pair_key(from_[tuning::kCopied]) < key &&
           blocks < tuning::kCopies) {
      copy(tuning::kCopied);
      ++blocks;
    }
    if (blocks == tuning::kCopies) copy_far(key);
    while (!from_.empty() && pair_key(from_[0]) < key) copy(1);
  }
  /// Whether it was there.
  bool leave_out(std::uint64_t key) {
    if (from_.empty() || pair_key(from_[0]) != key) return false;
    from_ = from_.subspan(1);
    return true;
  }
  void put(const AnyPair& pair) { *to_++ = pair; }

  void rest() { copy(from_.size()); }

  /// How many pairs are left.
  std::size_t left() const { return from_.size(); }
  /// Of what was written.
  AnyPair* end() const { return to_; }

 private:
  void copy(std::size_t count) {
    to_ = std::copy_n(from_.data(), count, to_);
    from_ = from_.subspan(count);
  }

  // Looks nearby first.
  void copy_far(std::uint64_t key) {
    std::size_t step = 1;
    while (step < from_.size() && pair_key(from_[step]) < key) step *= 2;
    const auto last = from_.begin() + static_cast<std::ptrdiff_t>(std::min(step + 1, from_.size()));
    const auto end = std::lower_bound(
        from_.begin(), last, key, [](const AnyPair& pair, std::uint64_t k) { return pair_key(pair) < k; });
    copy(static_cast<std::size_t>(end - from_.begin()));
  }

  std::span<const AnyPair> from_;
  AnyPair* to_;
};

/// Returns the end of what it wrote.
template <class AnyPair>
AnyPair* write_changed(std::span<const AnyPair> old, std::span<const AnyPair> began,
                       std::span<const AnyPair> ended, AnyPair* to) {
  RunCopy copy(old, to);
  while (!began.empty() || !ended.empty()) {
    // A pair that is in both lists ended with one body and began with another of the same number.
    const bool is_end = began.empty() || (!ended.empty() && pair_key(ended[0]) <= pair_key(began[0]));
    const AnyPair pair = is_end ? ended[0] : began[0];
    copy.until(pair_key(pair));
    if (is_end) {
      copy.leave_out(pair_key(pair));
      ended = ended.subspan(1);
    } else {
      copy.put(pair);
      began = began.subspan(1);
    }
  }
  copy.rest();
  return copy.end();
}

/// Where a worker begins, in each of the lists.
struct Start {
  std::size_t old = 0;
  std::size_t began = 0;
  std::size_t ended = 0;
};

/// Whether the next four of two lists are there and alike.
template <class AnyPair>
bool are_four_alike(std::span<const AnyPair> one, std::size_t i, std::span<const AnyPair> other,
                    std::size_t j) {
  if (i + 4 > one.size() || j + 4 > other.size()) return false;
  std::uint64_t differ = 0;
  for (std::size_t k = 0; k < 4; ++k) differ |= pair_key(one[i + k]) ^ pair_key(other[j + k]);
  return differ == 0;
}

}  // namespace

// Lists that differ in few places are compared four pairs at a time between them. Where they differ nobody
// can foretell: there is no branch on it otherwise.
template <class AnyPair>
ChangeRoom<AnyPair> write_changes(std::span<const AnyPair> old, std::span<const AnyPair> now,
                                  std::span<const std::uint32_t> gone, ChangeRoom<AnyPair> room) {
  auto [began, ended] = room;
  const auto is_gone = [&](std::uint32_t number) {
    return std::binary_search(gone.begin(), gone.end(), number);
  };
  std::size_t i = 0, j = 0;
  while (i < old.size() && j < now.size()) {
    const std::uint64_t before = pair_key(old[i]);
    const std::uint64_t after = pair_key(now[j]);
    const bool other = before == after && !gone.empty() && (is_gone(old[i].a) || is_gone(old[i].b));
    *ended = old[i];
    *began = now[j];
    ended += before < after || other ? 1 : 0;
    began += after < before || other ? 1 : 0;
    i += before <= after ? 1 : 0;
    j += after <= before ? 1 : 0;
    if (before != after || !gone.empty()) continue;
    while (are_four_alike(old, i, now, j)) i += 4, j += 4;
  }
  ended = std::copy(old.begin() + static_cast<std::ptrdiff_t>(i), old.end(), ended);
  began = std::copy(now.begin() + static_cast<std::ptrdiff_t>(j), now.end(), began);
  return {began, ended};
}

template <class AnyPair>
void find_changes(std::span<const AnyPair> old, std::span<const AnyPair> now,
                  std::span<const std::uint32_t> gone, Array<AnyPair>& began_list,
                  Array<AnyPair>& ended_list) {
  began_list.renew(now.size());
  ended_list.renew(old.size());
  const auto [began_end, ended_end] =
      write_changes(old, now, gone, ChangeRoom<AnyPair>{began_list.data(), ended_list.data()});
  began_list.shrink(static_cast<std::size_t>(began_end - began_list.data()));
  ended_list.shrink(static_cast<std::size_t>(ended_end - ended_list.data()));
}

template <class AnyPair>
void apply_changes(std::span<const AnyPair> old, std::span<const AnyPair> began,
                   std::span<const AnyPair> ended, Array<AnyPair>& now) {
  now.renew(old.size() + began.size());
  now.shrink(static_cast<std::size_t>(write_changed(old, began, ended, now.data()) - now.data()));
}

// Each worker's part of the old list and what changes from its first pair on to that of the next.
template <class AnyPair>
void apply_changes(Crew& crew, std::span<const AnyPair> old, std::span<const AnyPair> began,
                   std::span<const AnyPair> ended, Array<AnyPair>& now) {
  const std::size_t size = old.size() + began.size() - ended.size();
  const unsigned workers = old.size() < crew.active() ? 1 : crew.active();
  const auto start_of = [&](unsigned worker) -> Start {
    if (worker == 0) return {};
    if (worker == workers) return {old.size(), began.size(), ended.size()};
    const std::size_t first = Share::of(old.size(), worker, workers).first;
    return {first, count_below(began, old[first]), count_below(ended, old[first])};
  };
  now.renew(size);
  crew.run([&](unsigned worker) {
    if (worker >= workers) return;
    const Start from = start_of(worker);
    const Start to = start_of(worker + 1);
    write_changed(old.subspan(from.old, to.old - from.old), began.subspan(from.began, to.began - from.began),
                  ended.subspan(from.ended, to.ended - from.ended),
                  now.data() + from.old + from.began - from.ended);
  });
}

template <class AnyPair>
void apply_alternating(std::span<const AnyPair> old, std::span<const std::uint64_t> keys,
                       Array<AnyPair>& now) {
  now.renew(old.size() + keys.size());
  AlternatingMerge merge(old, keys, now.data());
  merge.go_on(old.size() + keys.size());
  now.shrink(static_cast<std::size_t>(merge.end() - now.data()));
}

// As many times as a pair is named does it change: an odd number of times is once.
template <class AnyPair>
bool AlternatingMerge<AnyPair>::go_on(std::size_t steps) {
  const auto part = old_.first(std::min(steps, old_.size()));
  const bool is_last = part.size() == old_.size();
  const std::uint64_t end = is_last ? 0 : pair_key(old_[part.size()]);
  const auto is_in_part = [&](std::size_t i) { return i < keys_.size() && (is_last || keys_[i] < end); };
  RunCopy copy(part, to_);
  std::size_t i = 0;
  for (; i < steps && is_in_part(i); ++i) {
    if (i + 1 < keys_.size() && keys_[i + 1] == keys_[i]) {
      ++i;
      continue;
    }
    copy.until(keys_[i]);
    if (!copy.leave_out(keys_[i])) copy.put(pair_of<AnyPair>(keys_[i]));
  }
  if (!is_in_part(i)) copy.rest();
  to_ = copy.end();
  old_ = old_.subspan(part.size() - copy.left());
  keys_ = keys_.subspan(i);
  return old_.empty() && keys_.empty();
}

template ChangeRoom<SlotPair> write_changes(std::span<const SlotPair>, std::span<const SlotPair>,
                                            std::span<const std::uint32_t>, ChangeRoom<SlotPair>);
template void find_changes(std::span<const Pair>, std::span<const Pair>, std::span<const std::uint32_t>,
                           Array<Pair>&, Array<Pair>&);
template void find_changes(std::span<const SlotPair>, std::span<const SlotPair>,
                           std::span<const std::uint32_t>, Array<SlotPair>&, Array<SlotPair>&);
template void apply_changes(std::span<const Pair>, std::span<const Pair>, std::span<const Pair>,
                            Array<Pair>&);
template void apply_changes(std::span<const SlotPair>, std::span<const SlotPair>, std::span<const SlotPair>,
                            Array<SlotPair>&);
template void apply_changes(Crew&, std::span<const SlotPair>, std::span<const SlotPair>,
                            std::span<const SlotPair>, Array<SlotPair>&);
template void apply_alternating(std::span<const Pair>, std::span<const std::uint64_t>, Array<Pair>&);
template void apply_alternating(std::span<const SlotPair>, std::span<const std::uint64_t>, Array<SlotPair>&);

template class AlternatingMerge<Pair>;
template class AlternatingMerge<SlotPair>;

}  // namespace cellsweep
