#include "base/key_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include "base/memory/array.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

using Key = std::uint64_t;

void insertion_sort(std::span<Key> keys) {
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const Key key = keys[i];
    std::size_t place = i;
    for (; place > 0 && keys[place - 1] > key; --place) keys[place] = keys[place - 1];
    keys[place] = key;
  }
}

/// Keys are in the right bucket, but in no order there; `ends` are the buckets'.
void sort_buckets(std::span<Key> keys, std::span<const std::uint32_t> ends) {
  std::uint32_t first = 0;
  std::uint32_t largest = 0;
  for (const std::uint32_t end : ends) largest = std::max(largest, end - first), first = end;
  if (largest <= tuning::kFewKeys) return insertion_sort(keys);
  first = 0;
  for (const std::uint32_t end : ends) {
    std::sort(keys.begin() + first, keys.begin() + end);
    first = end;
  }
}

/// Into which bucket a key belongs.
struct Buckets {
  Key least;
  unsigned shift;
  std::size_t count;

  explicit Buckets(std::span<const Key> keys) {
    const auto [smallest, largest] = std::ranges::minmax(keys);
    const auto bits = std::bit_width(largest - smallest);
    const auto wanted = std::bit_width(keys.size());
    least = smallest;
    shift = bits > wanted ? static_cast<unsigned>(bits - wanted) : 0U;
    count = ((largest - smallest) >> shift) + 1;
  }

  std::size_t of(Key key) const { return (key - least) >> shift; }
};

/// `ends` has a number for each bucket and one more, `sorted` one for each key.
void sort_by_buckets(std::span<Key> keys, const Buckets& buckets, std::span<std::uint32_t> ends,
                     std::span<Key> sorted) {
  std::ranges::fill(ends, 0U);
  for (const Key key : keys) ++ends[buckets.of(key) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  for (const Key key : keys) sorted[ends[buckets.of(key)]++] = key;
  sort_buckets(sorted, ends);
  std::ranges::copy(sorted, keys.begin());
}

}  // namespace

void sort_keys(std::span<Key> keys) {
  if (keys.size() <= tuning::kFewKeys) return insertion_sort(keys);
  const Buckets buckets(keys);
  constexpr std::size_t kOnStack = 256;
  if (keys.size() < kOnStack) {
    std::array<std::uint32_t, 2 * kOnStack + 1> ends;  // NOLINT(*-member-init): written before it is read
    std::array<Key, kOnStack> sorted;                  // NOLINT(*-member-init)
    return sort_by_buckets(keys, buckets, std::span(ends).first(buckets.count + 1),
                           std::span(sorted).first(keys.size()));
  }
  Array<std::uint32_t> ends;
  ends.renew(buckets.count + 1);
  Array<Key> sorted;
  sorted.renew(keys.size());
  sort_by_buckets(keys, buckets, ends.view(), sorted.view());
}

}  // namespace cellsweep
