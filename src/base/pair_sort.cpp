#include "base/pair_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "base/key_sort.h"
#include "base/pair_of.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

using Key = std::uint64_t;
using tuning::kBuckets;
using tuning::kCounters;
using tuning::kFewKeys;
using tuning::kNarrowest;
using tuning::kOneStep;

template <class AnyPair>
void insertion_sort(AnyPair* pairs, std::size_t count) {
  for (std::size_t i = 1; i < count; ++i) {
    const AnyPair pair = pairs[i];
    std::size_t place = i;
    for (; place > 0 && pairs[place - 1].b > pair.b; --place) pairs[place] = pairs[place - 1];
    pairs[place] = pair;
  }
}

// Pairs that have their first id in common.
template <class AnyPair>
void sort_by_second(AnyPair* pairs, std::size_t count) {
  if (count <= kFewKeys) return insertion_sort(pairs, count);
  std::sort(pairs, pairs + count, [](const AnyPair& one, const AnyPair& other) { return one.b < other.b; });
}

// Far apart first ids.
template <class AnyPair>
void sort_by_keys(std::span<Key> keys, AnyPair* sorted) {
  sort_keys(keys);
  std::transform(keys.begin(), keys.end(), sorted, pair_of<AnyPair>);
}

// Counts the first ids, which are `range` numbers from `low` on, then puts every pair where it belongs.
template <class AnyPair>
void sort_by_counting(std::span<const Key> keys, std::uint64_t low, std::uint64_t range, AnyPair* sorted) {
  std::array<std::uint32_t, kCounters> place;
  std::fill_n(place.begin(), range, 0);
  for (const Key key : keys) ++place[(key >> 32) - low];
  std::uint32_t sum = 0;
  for (std::uint64_t i = 0; i < range; ++i) {
    const std::uint32_t count = place[i];
    place[i] = sum;
    sum += count;
  }
  for (const Key key : keys) sorted[place[(key >> 32) - low]++] = pair_of<AnyPair>(key);
  std::uint32_t first = 0;
  for (std::uint64_t i = 0; i < range; ++i) {
    if (place[i] - first > 1) sort_by_second(sorted + first, place[i] - first);
    first = place[i];
  }
}

struct Range {
  std::uint64_t low = ~std::uint64_t{0};
  std::uint64_t high = 0;

  void include(Key key) {
    low = std::min(low, key >> 32);
    high = std::max(high, key >> 32);
  }
  std::uint64_t size() const { return high - low + 1; }
};

/// Keys whose first ids are known to lie in `range`.
template <class AnyPair>
void sort_in_range(std::span<Key> keys, const Range& range, AnyPair* sorted) {
  const bool is_dense = range.size() <= kCounters && range.size() <= 16 * keys.size();
  if (keys.size() > kFewKeys && is_dense) return sort_by_counting(keys, range.low, range.size(), sorted);
  sort_by_keys(keys, sorted);
}

template <class AnyPair>
void sort_bucket(std::span<Key> keys, AnyPair* sorted) {
  if (keys.size() <= kFewKeys) return sort_by_keys(keys, sorted);
  Range range;
  for (const Key key : keys) range.include(key);
  sort_in_range(keys, range, sorted);
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

  std::span<Key> bucket(std::size_t index) {
    return scratch_.view().subspan(first_[index], first_[index + 1] - first_[index]);
  }
  std::size_t first(std::size_t index) const { return first_[index]; }

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
      for_each_key(worker, [&](Key key) { range.include(key); });
      ranges[worker] = range;
    });
    for (const Range& range : ranges) {
      range_.low = std::min(range_.low, range.low);
      range_.high = std::max(range_.high, range.high);
    }
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

Range gather(KeyParts parts, Array<Key>& scratch) {
  Range range;
  Key* end = scratch.data();
  for (const std::span<const Key> part : parts) {
    for (const Key key : part) {
      range.include(key);
      *end++ = key;
    }
  }
  return range;
}

template <class AnyPair>
void sort_buckets(Crew& crew, Distribution& distribution, AnyPair* sorted) {
  crew.for_each(kBuckets, 8, [&](unsigned, std::size_t bucket) {
    sort_bucket(distribution.bucket(bucket), sorted + distribution.first(bucket));
  });
}

}  // namespace

template <class AnyPair>
void sort_pairs(Crew& crew, KeyParts parts, Array<std::uint64_t>& scratch, Array<AnyPair>& sorted) {
  const std::size_t total = count_keys(parts);
  sorted.renew(total);
  if (total == 0) return;
  if (total <= kOneStep) {
    scratch.renew(total);
    const Range range = gather(parts, scratch);
    return sort_in_range(scratch.view(), range, sorted.data());
  }
  Distribution distribution(crew, parts, scratch);
  distribution.run(total);
  sort_buckets(crew, distribution, sorted.data());
}

template void sort_pairs(Crew&, KeyParts, Array<std::uint64_t>&, Array<Pair>&);
template void sort_pairs(Crew&, KeyParts, Array<std::uint64_t>&, Array<SlotPair>&);

}  // namespace cellsweep
