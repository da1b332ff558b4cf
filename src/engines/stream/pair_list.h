/// @file
/// The current pairs of engine `stream`, always in ascending order, and how they change.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>

#include "cellsweep/broadphase.h"
#include "engines/stream/id_table.h"
#include "engines/stream/kernel.h"
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

/// Elements of a trivial type whose growth initialises nothing.
template <class T>
class Array {
 public:
  /// Makes it `size` elements long; what was in it is lost. Gives memory back when much less is needed.
  void renew(std::size_t size) {
    if (size > capacity_ || size + kKept < capacity_ / 8) {
      memory_.reset();
      capacity_ = size + size / 8;
      memory_.reset(static_cast<T*>(std::malloc(capacity_ * sizeof(T))));
      if (memory_ == nullptr && capacity_ > 0) {
        size_ = capacity_ = 0;
        throw std::bad_alloc();
      }
    }
    size_ = size;
  }
  /// Keeps the first `size` elements.
  void shrink(std::size_t size) { size_ = size; }

  T* data() { return memory_.get(); }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  std::span<T> view() { return {memory_.get(), size_}; }
  std::span<const T> view() const { return {memory_.get(), size_}; }

 private:
  static constexpr std::size_t kKept = 4096;
  struct Free {
    void operator()(T* memory) const { std::free(memory); }
  };

  std::unique_ptr<T, Free> memory_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

/// The current set, ascending, so that it does not matter in which order pairs are found.
class PairList {
 public:
  /// The pairs are now those of `found`, in any order, each once.
  PairChanges replace(Pool& pool, std::span<Keys* const> found);

  /// Pairs began and ended, in any order; one that is in both lists did neither.
  PairChanges change(Pool& pool, std::span<Keys* const> began, std::span<Keys* const> ended);

  /// The pairs are now those of `candidates`, ascending, whose boxes overlap.
  PairChanges keep_overlapping(Pool& pool, std::span<const Pair> candidates, std::span<const Aabb> boxes,
                               const IdTable& table);

  /// The pairs are those of another list; nothing began or ended by that.
  void copy(std::span<const Pair> pairs);

  std::span<const Pair> pairs() const { return pairs_.view(); }

  /// Bytes held.
  std::size_t bytes() const;

 private:
  void find_changes();
  void apply_changes();

  Array<Pair> pairs_;
  Array<Pair> spare_;  // the pairs before, or room for the next
  Array<Pair> began_;
  Array<Pair> ended_;
  Array<std::uint64_t> keys_;
};

}  // namespace cellsweep::stream
