/// @file
/// Keys of pairs in buckets of equally many first bodies, put there a part at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/sorting/pair_sort.h"
#include "base/threads/crew.h"
#include "cellsweep/function_ref.h"

namespace cellsweep {

/// The first bodies of a bucket are above those of the one before. The order in a bucket follows from the
/// parts, whoever works.
class KeyBuckets {
 public:
  /// Counts the keys, which stay where they are until all are distributed. That is done in so many parts, and
  /// workers take a part each: there are at least as many as may work.
  [[gnu::cold]] KeyBuckets(Crew& crew, KeyParts keys, std::size_t parts);

  /// Writes the keys of the next parts, until so many are done, to their buckets: there is room for all.
  void distribute(Crew& crew, std::size_t parts, std::uint64_t* to);

  std::size_t parts() const { return parts_; }
  bool are_full() const { return done_ == parts_; }

  /// Where buckets begin, and behind the last one how many keys there are.
  std::span<const std::size_t> begins() const { return begins_; }

  /// Bytes held.
  std::size_t bytes() const { return (places_.capacity() + begins_.capacity()) * sizeof(std::size_t); }

 private:
  template <class Visit>
  void for_each_key(std::size_t part, Visit&& visit) const;
  /// From the first one on that is not done, by all workers. By a reference to a function, for the size of
  /// programs.
  void for_each_part(Crew& crew, std::size_t end, FunctionRef<void(std::size_t)> job);
  [[gnu::cold]] void find_range(Crew& crew);
  [[gnu::noinline]] void count(std::size_t part);
  [[gnu::cold]] void make_prefix_sums();
  void distribute_part(std::size_t part, std::uint64_t* to);
  std::size_t bucket_of(std::uint64_t key) const { return ((key >> 32) - least_) >> shift_; }

  std::vector<std::span<const std::uint64_t>> keys_;
  std::size_t parts_;
  std::size_t done_ = 0;
  std::uint32_t least_ = 0;  // of the first bodies
  unsigned shift_ = 0;       // a bucket has 2^shift_ of them: a division would cost more than all else
  std::vector<std::size_t> places_;  // by part and bucket: first how many, then where the next one goes
  std::vector<std::size_t> begins_;
};

}  // namespace cellsweep
