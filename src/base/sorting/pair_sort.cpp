#include "base/sorting/pair_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include "base/sorting/key_sort.h"
#include "base/sorting/narrow_sort.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

using Key = std::uint64_t;
using tuning::kBuckets;
using tuning::kNarrowest;
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
  void include(const Range& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  std::uint64_t size() const { return std::uint64_t{high} - low + 1; }
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

/// The keys of several buffers cut into buckets of equally many first ids, by all workers.
class Distribution {
 public:
  Distribution(Crew& crew, KeyParts parts, Array<Key>& scratch)
      : crew_(crew), parts_(parts), scratch_(scratch), counts_(crew.active() * kBuckets) {}

  void run(std::size_t total) {
    find_range();
    shift_ = static_cast<unsigned>(std::bit_width(std::max(range_.size() / kBuckets, kNarrowest - 1)));
    scratch_.renew(total);
    crew_.run([&](unsigned worker) { count(worker); });
    make_prefix_sums();
    crew_.run([&](unsigned worker) { distribute(worker); });
  }

  std::vector<std::size_t> begins() const { return {first_.begin(), first_.end()}; }

 private:
  template <class Visit>
  void for_each_key(unsigned worker, Visit&& visit) const {
    for (const std::span<const Key> keys : parts_) {
      const Share share = Share::of(keys.size(), worker, crew_.active());
      for (std::size_t i = share.first; i < share.last; ++i) visit(keys[i]);
    }
  }

  void find_range() {
    std::vector<Range> ranges(crew_.active());
    crew_.run([&](unsigned worker) {
      Range range;
      for_each_key(worker, [&](Key key) { range.include(static_cast<std::uint32_t>(key >> 32)); });
      ranges[worker] = range;
    });
    for (const Range& range : ranges) range_.include(range);
  }

  std::size_t bucket_of(Key key) const { return ((key >> 32) - range_.low) >> shift_; }

  void count(unsigned worker) {
    std::array<std::size_t, kBuckets> counts{};
    for_each_key(worker, [&](Key key) { ++counts[bucket_of(key)]; });
    std::copy(counts.begin(), counts.end(), counts_.data() + worker * kBuckets);
  }

  void make_prefix_sums() {
    std::size_t sum = 0;
    for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
      first_[bucket] = sum;
      for (unsigned worker = 0; worker < crew_.active(); ++worker) {
        std::size_t& count = counts_[worker * kBuckets + bucket];
        const std::size_t place = sum;
        sum += count;
        count = place;
      }
    }
    first_[kBuckets] = sum;
  }

  void distribute(unsigned worker) {
    std::array<std::size_t, kBuckets> place{};
    std::copy_n(counts_.data() + worker * kBuckets, kBuckets, place.begin());
    Key* const keys = scratch_.data();
    for_each_key(worker, [&](Key key) { keys[place[bucket_of(key)]++] = key; });
  }

  Crew& crew_;
  KeyParts parts_;
  Array<Key>& scratch_;
  Range range_;
  unsigned shift_ = 0;  // a bucket has 2^shift_ first ids: a division would cost more than all else
  std::vector<std::size_t> counts_;  // by worker and bucket; then where the worker writes
  std::array<std::size_t, kBuckets + 1> first_{};
};

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

void sort_in_one_step(KeyParts parts, std::size_t total, Array<Key>& scratch, std::uint32_t* numbers) {
  if (total <= tuning::kFewKeys) return sort_few(parts, numbers);
  if (sort_narrow_pairs(parts, 0, scratch, numbers)) return;
  scratch.renew(2 * total);
  const std::span<Key> keys = scratch.view().first(total);
  const Ranges ranges = gather(parts, keys);
  sort_in_ranges(keys, scratch.view().last(total), ranges, numbers);
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

}  // namespace

bool are_sorted_in_parts(std::size_t keys) {
  return keys > kOneStep;
}

std::vector<std::size_t> distribute_pairs(Crew& crew, KeyParts parts, Array<Key>& scratch) {
  Distribution distribution(crew, parts, scratch);
  distribution.run(count_keys(parts));
  return distribution.begins();
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
  if (total == 0) return;
  if (total <= (crew.active() == 1 ? kOneStepAlone : kOneStep))
    return sort_in_one_step(parts, total, scratch, numbers_of(sorted));
  sort_some_buckets(crew, distribute_pairs(crew, parts, scratch), scratch, numbers_of(sorted));
}

template void sort_buckets(Crew&, std::span<const std::size_t>, std::size_t, std::size_t,
                           Array<std::uint64_t>&, Array<SlotPair>&);
template void sort_pairs(Crew&, KeyParts, Array<std::uint64_t>&, Array<Pair>&);
template void sort_pairs(Crew&, KeyParts, Array<std::uint64_t>&, Array<SlotPair>&);

}  // namespace cellsweep
