#include "base/sorting/pair_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include "base/sorting/key_buckets.h"
#include "base/sorting/key_sort.h"
#include "base/sorting/narrow_sort.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

using Key = std::uint64_t;
using tuning::kOneStep;
using tuning::kOneStepAlone;

/// The numbers that some bodies have.
struct Range {
  std::uint32_t low = ~std::uint32_t{0};
  std::uint32_t high = 0;

  void include(std::uint32_t number) {
    low = std::min(low, number);
    high = std::max(high, number);
  }
  unsigned bits() const { return static_cast<unsigned>(std::bit_width(high - low)); }
};

/// Of the first bodies and of the second ones.
struct Ranges {
  Range first;
  Range second;

  void include(Key key) {
    first.include(static_cast<std::uint32_t>(key >> 32));
    second.include(static_cast<std::uint32_t>(key));
  }
  KeyBits bits() const { return {first.bits(), second.bits()}; }
  /// The key in that many bits; keeps the order.
  Key narrowed(Key key) const {
    return ((key >> 32) - first.low) << second.bits() | (static_cast<std::uint32_t>(key) - second.low);
  }
  Key widened(Key key) const {
    const Key above = key >> second.bits();
    const Key below = key & ((Key{1} << second.bits()) - 1);
    return (above + first.low) << 32 | (below + second.low);
  }
};

/// Pairs of either kind, as their numbers: all that is done here is done once for both.
template <class AnyPair>
std::uint32_t* numbers_of(Array<AnyPair>& pairs) {
  static_assert(sizeof(AnyPair) == 2 * sizeof(std::uint32_t));
  return reinterpret_cast<std::uint32_t*>(pairs.data());
}

/// `spare` is as long.
void sort_in_ranges(std::span<Key> keys, std::span<Key> spare, const Ranges& ranges, std::uint32_t* numbers) {
  for (Key& key : keys) key = ranges.narrowed(key);
  for (const Key narrowed : sort_keys(keys, spare, ranges.bits())) {
    const Key key = ranges.widened(narrowed);
    *numbers++ = static_cast<std::uint32_t>(key >> 32);
    *numbers++ = static_cast<std::uint32_t>(key);
  }
}

void sort_bucket(std::span<Key> keys, Array<Key>& spare, std::uint32_t* numbers) {
  Ranges ranges;
  for (const Key key : keys) ranges.include(key);
  const std::span<const Key> all = keys;
  if (sort_narrow_pairs({&all, 1}, ranges.first.low, spare, numbers)) return;
  spare.renew(keys.size());
  sort_in_ranges(keys, spare.view(), ranges, numbers);
}

Ranges gather(KeyParts parts, std::span<Key> keys) {
  Ranges ranges;
  Key* end = keys.data();
  for (const std::span<const Key> part : parts) {
    for (const Key key : part) {
      ranges.include(key);
      *end++ = key;
    }
  }
  return ranges;
}

/// At most kFewKeys. After an update in which hardly anybody moved that is all there is to sort, and the rest
/// of this file is not in the caches.
void sort_few(KeyParts parts, std::uint32_t* numbers) {
  std::array<Key, tuning::kFewKeys> keys;  // NOLINT(*-member-init): written before it is read
  Key* end = keys.data();
  for (const std::span<const Key> part : parts) end = std::copy(part.begin(), part.end(), end);
  const std::span<Key> few(keys.data(), end);
  sort_few_keys(few);
  for (const Key key : few) {
    *numbers++ = static_cast<std::uint32_t>(key >> 32);
    *numbers++ = static_cast<std::uint32_t>(key);
  }
}

/// False when buckets are quicker.
bool sort_in_one_step(const Crew& crew, KeyParts parts, std::size_t total, Array<Key>& scratch,
                      std::uint32_t* numbers) {
  if (total <= tuning::kFewKeys) {
    sort_few(parts, numbers);
    return true;
  }
  const std::size_t most_narrow = crew.active() <= 2 ? kOneStepAlone : kOneStep;
  if (total <= most_narrow && sort_narrow_pairs(parts, 0, scratch, numbers)) return true;
  if (total > kOneStep) return false;
  scratch.renew(2 * total);
  const std::span<Key> keys = scratch.view().first(total);
  const Ranges ranges = gather(parts, keys);
  sort_in_ranges(keys, scratch.view().last(total), ranges, numbers);
  return true;
}

void sort_some_buckets(Crew& crew, std::span<const std::size_t> begins, Array<Key>& scratch,
                       std::uint32_t* numbers) {
  std::vector<Array<Key>> spares(crew.active());
  const std::span<Key> keys = scratch.view();
  crew.for_each(begins.size() - 1, 8, [&](unsigned worker, std::size_t i) {
    const auto bucket = keys.subspan(begins[i], begins[i + 1] - begins[i]);
    sort_bucket(bucket, spares[worker], numbers + 2 * begins[i]);
  });
}

void sort_all(Crew& crew, KeyParts parts, std::size_t total, Array<Key>& scratch, std::uint32_t* numbers) {
  if (sort_in_one_step(crew, parts, total, scratch, numbers)) return;
  KeyBuckets buckets(crew, parts, crew.active());
  scratch.renew(total);
  buckets.distribute(crew, buckets.parts(), scratch.data());
  sort_some_buckets(crew, buckets.begins(), scratch, numbers);
}

}  // namespace

bool are_sorted_in_parts(std::size_t keys) {
  return keys > kOneStep;
}

template <class AnyPair>
void sort_buckets(Crew& crew, std::span<const std::size_t> begins, std::size_t first, std::size_t count,
                  Array<Key>& scratch, Array<AnyPair>& sorted) {
  sort_some_buckets(crew, begins.subspan(first, count + 1), scratch, numbers_of(sorted));
}

template <class AnyPair>
void sort_pairs(Crew& crew, KeyParts parts, Array<std::uint64_t>& scratch, Array<AnyPair>& sorted) {
  const std::size_t total = count_keys(parts);
  sorted.renew(total);
  if (total > 0) sort_all(crew, parts, total, scratch, numbers_of(sorted));
}

template void sort_buckets(Crew&, std::span<const std::size_t>, std::size_t, std::size_t,
                           Array<std::uint64_t>&, Array<SlotPair>&);
template void sort_pairs(Crew&, KeyParts, Array<std::uint64_t>&, Array<Pair>&);
template void sort_pairs(Crew&, KeyParts, Array<std::uint64_t>&, Array<SlotPair>&);

}  // namespace cellsweep
