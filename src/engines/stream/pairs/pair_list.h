/// @file
/// The current pairs of engine `stream`, always in ascending order, and how they change.
#pragma once

#include <cstdint>
#include <span>

#include "cellsweep/broadphase.h"
#include "engines/stream/kernels/kernel.h"
#include "base/memory/array.h"
#include "engines/stream/pool.h"

namespace cellsweep::stream {

/// A KeyBuffer that owns its memory.
class Keys {
 public:
  Keys();
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;
  ~Keys();

  KeyBuffer& buffer() { return buffer_; }
  std::span<const std::uint64_t> view() const { return {buffer_.keys, buffer_.size}; }
  /// Empties it; gives memory back when there was use for little of it.
  void clear();

 private:
  KeyBuffer buffer_;
};

/// What differs between two ascending lists; the memory is that of `began` and `ended`.
PairChanges find_changes(std::span<const Pair> old, std::span<const Pair> now, Array<Pair>& began,
                         Array<Pair>& ended);

/// No limit to the number of pairs.
inline constexpr std::size_t kAnyNumber = ~std::size_t{0};

/// A set of pairs, ascending, so that it does not matter in which order they are found. A call that runs out
/// of memory, or throws TooManyPairs because there would be more than `most`, leaves the set as it was.
class PairList {
 public:
  /// The pairs are now those of `found`, in any order, each once.
  PairChanges replace(Pool& pool, std::span<Keys* const> found, std::size_t most = kAnyNumber);

  /// Pairs began and ended, in any order; one that is in both lists did neither.
  PairChanges change(Pool& pool, std::span<Keys* const> began, std::span<Keys* const> ended,
                     std::size_t most = kAnyNumber);

  std::span<const Pair> pairs() const { return pairs_.view(); }

  /// Bytes held.
  std::size_t bytes() const;

 private:
  void apply_changes();

  Array<Pair> pairs_;
  Array<Pair> spare_;  // room for the next
  Array<Pair> began_;
  Array<Pair> ended_;
  Array<std::uint64_t> keys_;
};

}  // namespace cellsweep::stream
