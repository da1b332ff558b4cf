#include "base/pairs/pair_changes.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/pairs/pair_of.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

/// Copies a list from place to place.
template <class AnyPair>
class RunCopy {
 public:
  /// There is room for so many.
  RunCopy(std::span<const AnyPair> from, AnyPair* to, std::size_t room)
      : from_(from), to_(to), end_(to + room) {}

  /// All that is below the key.
  void until(std::uint64_t key) {
    // Changes are many or few: most runs are short.
    std::size_t blocks = 0;
    while (from_.size() > tuning::kCopied && pair_key(from_[tuning::kCopied]) < key &&
           blocks < tuning::kCopies) {
      copy_next();
      to_ += tuning::kCopied;
      from_ = from_.subspan(tuning::kCopied);
      ++blocks;
    }
    if (blocks == tuning::kCopies) copy_far(key);
    if (from_.size() >= tuning::kCopied && room() >= tuning::kCopied) return copy_some(key);
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

  // Not std::copy_n, which for so few bytes would call a function: lists might overlap.
  void copy_next() { std::memcpy(to_, from_.data(), tuning::kCopied * sizeof(AnyPair)); }

  // Of the next few those below the key, behind which no more are: no branch depends on how many.
  void copy_some(std::uint64_t key) {
    std::size_t below = 0;
    for (std::size_t i = 0; i < tuning::kCopied; ++i) below += pair_key(from_[i]) < key ? 1U : 0U;
    copy_next();
    to_ += below;
    from_ = from_.subspan(below);
  }

  std::size_t room() const { return static_cast<std::size_t>(end_ - to_); }

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
  AnyPair* end_;
};

/// To tell whether two are the same: in one number, and not in their order.
template <class AnyPair>
std::uint64_t bits_of(const AnyPair& pair) {
  return std::bit_cast<std::uint64_t>(pair);
}

/// The same as write_changed(), of lists with many changes: a pair at a time. Which list it is from nobody
/// can foretell, and no branch depends on it.
template <class AnyPair>
AnyPair* write_much_changed(std::span<const AnyPair> old, std::span<const AnyPair> began,
                            std::span<const AnyPair> ended, AnyPair* to) {
  constexpr AnyPair kNoPair{};  // of a number with itself
  const AnyPair* const end = to + (old.size() + began.size() - ended.size());
  const AnyPair* const last_end = ended.empty() ? &kNoPair : &ended.back();
  const AnyPair* next_end = ended.empty() ? &kNoPair : ended.data();
  const AnyPair* one = old.data();
  const AnyPair* const one_end = one + old.size();
  const AnyPair* other = began.data();
  const AnyPair* const other_end = other + began.size();
  const auto put = [&](std::uint64_t pair, std::uint64_t is_old) {
    const std::uint64_t is_end = is_old & (pair == bits_of(*next_end) ? 1 : 0);
    *to = std::bit_cast<AnyPair>(pair);
    to += is_end ^ 1;
    next_end += is_end & (next_end != last_end ? 1 : 0);
  };
  while (one != one_end && other != other_end && to != end) {
    const std::uint64_t is_old = pair_key(*one) <= pair_key(*other) ? 1 : 0;
    const std::uint64_t differ = bits_of(*one) ^ bits_of(*other);
    put(bits_of(*other) ^ (differ & (0 - is_old)), is_old);
    one += is_old;
    other += is_old ^ 1;
  }
  for (; one != one_end && to != end; ++one) put(bits_of(*one), 1);
  return std::copy(other, other_end, to);
}

/// Returns the end of what it wrote.
template <class AnyPair>
AnyPair* write_changed(std::span<const AnyPair> old, std::span<const AnyPair> began,
                       std::span<const AnyPair> ended, AnyPair* to) {
  if (began.size() + ended.size() > old.size() / tuning::kPairsOfChange)
    return write_much_changed(old, began, ended, to);
  RunCopy copy(old, to, old.size() + began.size() - ended.size());
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

/// How many of the next four of two lists are alike, before one that is not: no branch tells.
template <class AnyPair>
std::size_t alike_of_four(const AnyPair* one, const AnyPair* other) {
  std::size_t count = 0;
  std::size_t still = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    still &= bits_of(one[k]) == bits_of(other[k]) ? 1U : 0U;
    count += still;
  }
  return count;
}

}  // namespace

// Four pairs at a time. Of two that are not alike the lesser one is in its list alone: which one that is
// nobody can foretell, and no branch depends on it.
template <class AnyPair>
ChangeRoom<AnyPair> write_changes(std::span<const AnyPair> old, std::span<const AnyPair> now,
                                  std::span<const std::uint32_t> gone, ChangeRoom<AnyPair> room) {
  const auto is_gone = [&](std::uint32_t number) {
    return std::binary_search(gone.begin(), gone.end(), number);
  };
  auto [began, ended] = room;
  std::size_t i = 0, j = 0;
  while (gone.empty() && i + 4 <= old.size() && j + 4 <= now.size()) {
    const std::size_t alike = alike_of_four(&old[i], &now[j]);
    i += alike;
    j += alike;
    if (alike == 4) continue;
    const std::size_t is_end = pair_key(old[i]) < pair_key(now[j]) ? 1 : 0;
    *ended = old[i];
    *began = now[j];
    ended += is_end;
    i += is_end;
    began += is_end ^ 1;
    j += is_end ^ 1;
  }
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
  RunCopy copy(part, to_, old_.size() + keys_.size());
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
