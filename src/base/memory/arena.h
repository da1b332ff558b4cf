/// @file
/// Memory that is given out piece by piece and taken back all at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/memory/memory.h"

namespace cellsweep {

/// Hands out blocks of uninitialised memory for trivial types, 64-byte aligned. One thread at a time.
class Arena {
 public:
  /// A place to go back to.
  struct Mark {
    std::size_t chunk = 0;
    std::size_t used = 0;
  };

  /// `count` uninitialised elements, valid until a release() to before them, or reset().
  template <class T>
  T* take(std::size_t count) {
    return static_cast<T*>(take_bytes(count * sizeof(T)));
  }

  Mark mark() const { return {current_, used_}; }

  /// Takes back everything handed out since the mark.
  void release(Mark mark);

  /// Takes back everything; keeps as much memory as was handed out since the last reset, and little more than
  /// `most` bytes.
  void reset(std::size_t most);

  /// Gives back all memory in which nothing was handed out, as far as the system takes a part of a block.
  [[gnu::cold]] void fit();

  /// Bytes held from the system, handed out or not.
  std::size_t bytes() const { return bytes_; }

 private:
  struct Chunk {
    Memory<std::byte> memory;
    std::size_t size = 0;
  };

  void* take_bytes(std::size_t bytes);
  void* take_from_next_chunk(std::size_t bytes);
  [[gnu::noinline]] void give_behind(std::size_t chunks);

  std::vector<Chunk> chunks_;
  std::size_t current_ = 0;  // index of the chunk in use
  std::size_t used_ = 0;     // of it
  std::size_t bytes_ = 0;
};

/// Goes back to where an arena stood when the scope began.
class ArenaScope {
 public:
  explicit ArenaScope(Arena& arena) : arena_(arena), mark_(arena.mark()) {}
  ArenaScope(const ArenaScope&) = delete;
  ArenaScope& operator=(const ArenaScope&) = delete;
  ~ArenaScope() { arena_.release(mark_); }

 private:
  Arena& arena_;
  Arena::Mark mark_;
};

}  // namespace cellsweep
