#include "broadphase/bodies/distinct_ids.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/memory/array.h"
#include "base/memory/list.h"
#include "base/memory/memory.h"
#include "base/sorting/key_sort.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

/// The product of an id with the golden ratio, which scatters runs: the upper half is its hash, the lower one
/// chooses its bucket.
std::uint64_t scattered(BodyId id) {
  return id * 0x9e3779b97f4a7c15U;
}

/// For each value of a hash a bit: whether an id has it, and whether a second one has.
class HashBits {
 public:
  explicit HashBits(std::size_t ids)
      : bits_(static_cast<unsigned>(std::bit_width(std::max(ids * tuning::kBitsOfId, std::size_t{64}) - 1))),
        words_((std::size_t{1} << bits_) / 64) {}

  void add(BodyId id) {
    const std::uint64_t hash = hash_of(id);
    Words& words = words_[hash / 64];
    const std::uint64_t bit = std::uint64_t{1} << hash % 64;
    words.twice |= words.once & bit;
    words.once |= bit;
  }

  bool is_shared(BodyId id) const {
    const std::uint64_t hash = hash_of(id);
    return (words_[hash / 64].twice >> hash % 64 & 1) != 0;
  }

 private:
  struct Words {
    std::uint64_t once = 0;
    std::uint64_t twice = 0;
  };

  std::uint64_t hash_of(BodyId id) const { return scattered(id) >> (64 - bits_); }

  unsigned bits_;
  Vector<Words> words_;
};

/// Those whose hashes another one has; nearly none where ids are few and all differ.
List<std::uint64_t> list_shared(const HashBits& hashes, std::span<const BodyId> ids) {
  constexpr std::size_t kBlock = 512;
  List<std::uint64_t> shared;
  for (std::size_t first = 0; first < ids.size(); first += kBlock) {
    const auto block = ids.subspan(first, std::min(kBlock, ids.size() - first));
    shared.reserve(shared.size() + block.size());
    std::uint64_t* end = shared.data() + shared.size();
    for (const BodyId id : block) {
      *end = id;
      end += hashes.is_shared(id) ? 1 : 0;
    }
    shared.set_size(static_cast<std::size_t>(end - shared.data()));
  }
  return shared;
}

bool all_differ(std::span<const BodyId> ids) {
  HashBits hashes(ids.size());
  for (const BodyId id : ids) hashes.add(id);
  List<std::uint64_t> shared = list_shared(hashes, ids);
  sort_keys(shared.view());
  return std::ranges::adjacent_find(shared.view()) == shared.view().end();
}

/// Many ids, cut into buckets so small that the bits of one stay in a fast cache; alike ones get into the
/// same.
class IdBuckets {
 public:
  IdBuckets(Crew& crew, std::span<const BodyId> ids)
      : crew_(crew),
        ids_(ids),
        buckets_(std::bit_ceil(ids.size() / tuning::kIdsOfBucket + 1)),
        places_(crew.active() * buckets_) {
    cut_.renew(ids.size());
    crew.run([&](unsigned worker) { count(worker); });
    make_prefix_sums();
    crew.run([&](unsigned worker) { distribute(worker); });
  }

  bool all_differ() const {
    std::atomic<bool> differ = true;
    crew_.for_each(buckets_, 1, [&](unsigned, std::size_t bucket) {
      if (!cellsweep::all_differ(this->bucket(bucket))) differ = false;
    });
    return differ;
  }

 private:
  std::size_t bucket_of(BodyId id) const { return (scattered(id) & 0xffffffff) * buckets_ >> 32; }

  std::span<const BodyId> bucket(std::size_t index) const {
    const std::size_t first = index == 0 ? 0 : last_place(index - 1);
    return cut_.view().subspan(first, last_place(index) - first);
  }
  // Behind what the last worker wrote.
  std::size_t last_place(std::size_t bucket) const {
    return places_[(crew_.active() - 1) * buckets_ + bucket];
  }

  std::span<const BodyId> share_of(unsigned worker) const {
    const Share share = Share::of(ids_.size(), worker, crew_.active());
    return ids_.subspan(share.first, share.last - share.first);
  }

  void count(unsigned worker) {
    std::size_t* const counts = &places_[worker * buckets_];
    for (const BodyId id : share_of(worker)) ++counts[bucket_of(id)];
  }

  void make_prefix_sums() {
    std::size_t sum = 0;
    for (std::size_t bucket = 0; bucket < buckets_; ++bucket) {
      for (unsigned worker = 0; worker < crew_.active(); ++worker)
        sum += std::exchange(places_[worker * buckets_ + bucket], sum);
    }
  }

  void distribute(unsigned worker) {
    std::size_t* const places = &places_[worker * buckets_];
    BodyId* const to = cut_.data();
    for (const BodyId id : share_of(worker)) to[places[bucket_of(id)]++] = id;
  }

  Crew& crew_;
  std::span<const BodyId> ids_;
  std::size_t buckets_;
  Vector<std::size_t> places_;  // by worker and bucket: how many ids, then where the next one goes
  Array<BodyId> cut_;
};

}  // namespace

bool are_distinct(Crew& crew, std::span<const BodyId> ids) {
  return ids.size() <= tuning::kIdsOfBucket ? all_differ(ids) : IdBuckets(crew, ids).all_differ();
}

}  // namespace cellsweep
