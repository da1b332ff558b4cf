#include "engines/stream/pairs/pair_list.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "broadphase/pairs/pair_sort.h"

namespace cellsweep::stream {
namespace {

void grow_keys(KeyBuffer& buffer, std::size_t more) {
  if (buffer.size > buffer.most) throw TooManyPairs();
  const std::size_t capacity = std::max(2 * buffer.capacity, buffer.size + more + 1000);
  auto* memory = reinterpret_cast<std::byte*>(buffer.keys);
  buffer.keys = reinterpret_cast<std::uint64_t*>(grow_memory(memory, capacity * sizeof(std::uint64_t)));
  buffer.capacity = capacity;
}

/// Leaves out of two ascending lists what is in both.
void cancel_equal(Array<Pair>& one, Array<Pair>& other) {
  std::size_t i = 0, j = 0, i_kept = 0, j_kept = 0;
  Pair* a = one.data();
  Pair* b = other.data();
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

Keys::Keys() {
  buffer_.grow = grow_keys;
}

void Keys::clear() {
  constexpr std::size_t kKept = 4096;
  if (buffer_.capacity > kKept && buffer_.size < buffer_.capacity / 8) {
    give_memory(buffer_.keys);
    buffer_.keys = nullptr;
    buffer_.capacity = 0;
  }
  buffer_.size = 0;
}

Keys::~Keys() {
  give_memory(buffer_.keys);
}

PairChanges find_changes(std::span<const Pair> old, std::span<const Pair> now, Array<Pair>& began_list,
                         Array<Pair>& ended_list) {
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

PairChanges PairList::replace(Pool& pool, std::span<Keys* const> found, std::size_t most) {
  sort_pairs(pool, found, keys_, spare_);
  if (spare_.size() > most) throw TooManyPairs();
  const bool first = pairs_.size() == 0;
  const PairChanges changes = first ? PairChanges{std::as_const(spare_).view(), {}}
                                    : find_changes(pairs_.view(), spare_.view(), began_, ended_);
  std::swap(pairs_, spare_);
  return changes;
}

PairChanges PairList::change(Pool& pool, std::span<Keys* const> began, std::span<Keys* const> ended,
                             std::size_t most) {
  sort_pairs(pool, began, keys_, began_);
  sort_pairs(pool, ended, keys_, ended_);
  cancel_equal(began_, ended_);
  if (pairs_.size() + began_.size() - ended_.size() > most) throw TooManyPairs();
  if (began_.size() + ended_.size() > 0) apply_changes();
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

// What lies between two changes is copied as a whole.
void PairList::apply_changes() {
  const std::span<const Pair> began = began_.view();
  const std::span<const Pair> ended = ended_.view();
  const std::span<const Pair> old = pairs_.view();
  spare_.renew(old.size() + began.size() - ended.size());
  Pair* to = spare_.data();
  std::size_t from = 0;
  std::size_t b = 0;
  std::size_t e = 0;
  const auto copy_until = [&](std::uint64_t key) {
    // Changes are many or few: look nearby first.
    std::size_t step = 1;
    while (from + step < old.size() && pair_key(old[from + step]) < key) step *= 2;
    const auto first = old.begin() + static_cast<std::ptrdiff_t>(from);
    const auto last = old.begin() + static_cast<std::ptrdiff_t>(std::min(from + step + 1, old.size()));
    const auto end = std::lower_bound(first, last, key,
                                      [](const Pair& pair, std::uint64_t k) { return pair_key(pair) < k; });
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

std::size_t PairList::bytes() const {
  return pairs_.bytes() + spare_.bytes() + began_.bytes() + ended_.bytes() + keys_.bytes();
}

}  // namespace cellsweep::stream
