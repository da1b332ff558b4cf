#include "base/key_sort.h"

#include <algorithm>
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

/// The buckets' ends, from that of an empty one before the first on.
std::uint32_t* count_into(std::span<const Key> keys, Key least, unsigned shift, Array<std::uint32_t>& ends) {
  std::fill_n(ends.data(), ends.size(), 0U);
  for (const Key key : keys) ++ends.data()[((key - least) >> shift) + 1];
  std::partial_sum(ends.data(), ends.data() + ends.size(), ends.data());
  return ends.data();
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

}  // namespace

void sort_keys(std::span<Key> keys) {
  if (keys.size() <= tuning::kFewKeys) return insertion_sort(keys);
  if (keys.size() <= tuning::kCompared) return std::sort(keys.begin(), keys.end());
  const auto [least, most] = std::ranges::minmax(keys);
  const auto bits = std::bit_width(most - least);
  const auto wanted = std::bit_width(keys.size());
  const auto shift = bits > wanted ? static_cast<unsigned>(bits - wanted) : 0U;
  Array<std::uint32_t> ends;
  ends.renew(((most - least) >> shift) + 2);
  Array<Key> sorted;
  sorted.renew(keys.size());
  std::uint32_t* const next = count_into(keys, least, shift, ends);
  for (const Key key : keys) sorted.data()[next[(key - least) >> shift]++] = key;
  sort_buckets(sorted.view(), ends.view());
  std::copy_n(sorted.data(), sorted.size(), keys.begin());
}

}  // namespace cellsweep
