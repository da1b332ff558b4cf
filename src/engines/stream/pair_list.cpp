#include "engines/stream/pair_list.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include "engines/stream/pair_sort.h"

namespace cellsweep::stream {
namespace {

void grow_keys(KeyBuffer& buffer, std::size_t more) {
  const std::size_t capacity = std::max(2 * buffer.capacity, buffer.size + more + 1000);
  void* memory = std::realloc(buffer.keys, capacity * sizeof(std::uint64_t));
  if (memory == nullptr) throw std::bad_alloc();
  buffer.keys = static_cast<std::uint64_t*>(memory);
  buffer.capacity = capacity;
}

bool overlap_without_branches(const Aabb& a, const Aabb& b) {
  return (static_cast<unsigned>(a.min[0] <= b.max[0]) & static_cast<unsigned>(b.min[0] <= a.max[0]) &
          static_cast<unsigned>(a.min[1] <= b.max[1]) & static_cast<unsigned>(b.min[1] <= a.max[1]) &
          static_cast<unsigned>(a.min[2] <= b.max[2]) & static_cast<unsigned>(b.min[2] <= a.max[2])) != 0;
}

/// Copies the candidates that overlap; returns how many.
template <class SlotOf>
std::size_t filter(std::span<const Pair> candidates, std::span<const Aabb> boxes, Pair* to,
                   const SlotOf& slot_of) {
  const Pair* const first = to;
  for (const Pair& pair : candidates) {
    *to = pair;
    to += overlap_without_branches(boxes[slot_of(pair.a)], boxes[slot_of(pair.b)]) ? 1 : 0;
  }
  return static_cast<std::size_t>(to - first);
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
    std::free(buffer_.keys);
    buffer_.keys = nullptr;
    buffer_.capacity = 0;
  }
  buffer_.size = 0;
}

Keys::~Keys() {
  std::free(buffer_.keys);
}

PairChanges PairList::replace(Pool& pool, std::span<Keys* const> found) {
  std::swap(pairs_, spare_);
  sort_pairs(pool, found, keys_, pairs_);
  if (spare_.size() == 0) return {pairs_.view(), {}};
  find_changes();
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

// Pairs before are in spare_, pairs now in pairs_.
void PairList::find_changes() {
  const std::span<const Pair> old = spare_.view();
  const std::span<const Pair> now = pairs_.view();
  began_.renew(now.size());
  ended_.renew(old.size());
  Pair* began = began_.data();
  Pair* ended = ended_.data();
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
  ended = std::copy(old.begin() + i, old.end(), ended);
  began = std::copy(now.begin() + j, now.end(), began);
  began_.shrink(static_cast<std::size_t>(began - began_.data()));
  ended_.shrink(static_cast<std::size_t>(ended - ended_.data()));
}

void PairList::copy(std::span<const Pair> pairs) {
  pairs_.renew(pairs.size());
  std::copy(pairs.begin(), pairs.end(), pairs_.data());
}

PairChanges PairList::keep_overlapping(Pool& pool, std::span<const Pair> candidates,
                                       std::span<const Aabb> boxes, const IdTable& table) {
  std::swap(pairs_, spare_);
  pairs_.renew(candidates.size());
  Pair* const to = pairs_.data();
  std::vector<std::size_t> kept(pool.active());
  pool.run([&](unsigned worker) {
    const Share share = Share::of(candidates.size(), worker, pool.active());
    const auto mine = candidates.subspan(share.first, share.last - share.first);
    kept[worker] = table.ids() == nullptr
                       ? filter(mine, boxes, to + share.first, [](BodyId id) { return id; })
                       : filter(mine, boxes, to + share.first, [&](BodyId id) { return table.find(id); });
  });
  std::size_t size = kept[0];
  for (unsigned worker = 1; worker < pool.active(); ++worker) {
    const Share share = Share::of(candidates.size(), worker, pool.active());
    std::memmove(to + size, to + share.first, kept[worker] * sizeof(Pair));
    size += kept[worker];
  }
  pairs_.shrink(size);
  find_changes();
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

PairChanges PairList::change(Pool& pool, std::span<Keys* const> began, std::span<Keys* const> ended) {
  sort_pairs(pool, began, keys_, began_);
  sort_pairs(pool, ended, keys_, ended_);
  cancel_equal(began_, ended_);
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
  return (pairs_.capacity() + spare_.capacity() + began_.capacity() + ended_.capacity()) * sizeof(Pair) +
         keys_.capacity() * sizeof(std::uint64_t);
}

}  // namespace cellsweep::stream
