#include "base/sorting/key_buckets.h"

#include <algorithm>
#include <array>
#include <bit>

#include "base/tuning.h"

namespace cellsweep {
namespace {

using tuning::kBuckets;
using tuning::kNarrowest;

}  // namespace

KeyBuckets::KeyBuckets(Crew& crew, KeyParts keys, std::size_t parts)
    : keys_(keys.begin(), keys.end()), parts_(parts), places_(parts * kBuckets), begins_(kBuckets + 1) {
  find_range(crew);
  for_each_part(crew, parts, [&](std::size_t part) { count(part); });
  make_prefix_sums();
}

void KeyBuckets::for_each_part(Crew& crew, std::size_t end, FunctionRef<void(std::size_t)> job) {
  const std::size_t first = done_;
  crew.for_each(end - first, 1, [&](unsigned, std::size_t part) { job(first + part); });
}

template <class Visit>
void KeyBuckets::for_each_key(std::size_t part, Visit&& visit) const {
  for (const std::span<const std::uint64_t> keys : keys_) {
    const Share share = Share::of(keys.size(), static_cast<unsigned>(part), static_cast<unsigned>(parts_));
    for (std::size_t i = share.first; i < share.last; ++i) visit(keys[i]);
  }
}

void KeyBuckets::find_range(Crew& crew) {
  struct Range {
    std::uint32_t least = ~std::uint32_t{0};
    std::uint32_t last = 0;
  };
  std::vector<Range> ranges(parts_);
  for_each_part(crew, parts_, [&](std::size_t part) {
    Range range;
    for_each_key(part, [&](std::uint64_t key) {
      const auto first_body = static_cast<std::uint32_t>(key >> 32);
      range.least = std::min(range.least, first_body);
      range.last = std::max(range.last, first_body);
    });
    ranges[part] = range;
  });
  Range all;
  for (const Range& range : ranges) {
    all.least = std::min(all.least, range.least);
    all.last = std::max(all.last, range.last);
  }
  least_ = all.least;
  const std::uint64_t bodies = std::uint64_t{all.last} - all.least + 1;
  shift_ = static_cast<unsigned>(std::bit_width(std::max(bodies / kBuckets, kNarrowest - 1)));
}

void KeyBuckets::count(std::size_t part) {
  std::array<std::size_t, kBuckets> counts{};
  for_each_key(part, [&](std::uint64_t key) { ++counts[bucket_of(key)]; });
  std::copy(counts.begin(), counts.end(), places_.data() + part * kBuckets);
}

void KeyBuckets::make_prefix_sums() {
  std::size_t sum = 0;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    begins_[bucket] = sum;
    for (std::size_t part = 0; part < parts_; ++part) {
      std::size_t& place = places_[part * kBuckets + bucket];
      const std::size_t count = place;
      place = sum;
      sum += count;
    }
  }
  begins_[kBuckets] = sum;
}

void KeyBuckets::distribute(Crew& crew, std::size_t parts, std::uint64_t* to) {
  if (parts <= done_) return;
  for_each_part(crew, parts, [&](std::size_t part) { distribute_part(part, to); });
  done_ = parts;
}

void KeyBuckets::distribute_part(std::size_t part, std::uint64_t* to) {
  std::array<std::size_t, kBuckets> places;  // NOLINT(*-member-init): written before it is read
  std::copy_n(places_.data() + part * kBuckets, kBuckets, places.begin());
  for_each_key(part, [&](std::uint64_t key) { to[places[bucket_of(key)]++] = key; });
}

}  // namespace cellsweep
