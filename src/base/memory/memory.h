/// @file
/// Where large arrays get their memory from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <utility>
#include <vector>

namespace cellsweep {

/// How memory is aligned that whole vectors are loaded from: to the lines of a cache.
inline constexpr std::size_t kMemoryAlignment = 64;
/// What a huge page of the system holds.
inline constexpr std::size_t kHugePage = std::size_t{2} << 20;

/// Uninitialised memory, aligned as any type needs or as is asked for, which takes some hundred bodies' time
/// more; a block of some megabytes asks for huge pages: a page fault costs as much. Throws std::bad_alloc.
/// Safe to call from any thread.
std::byte* take_memory(std::size_t bytes, std::size_t alignment = alignof(std::max_align_t));
/// The same for what is read here and there again and again: also a larger block asks for huge pages, so that
/// fewer of its reads wait for where a page is.
std::byte* take_huge_pages(std::size_t bytes, std::size_t alignment = alignof(std::max_align_t));
void give_memory(void* memory);

/// More memory, for `bytes`, that begins with the `held` bytes that `memory` has, which it replaces; null has
/// none. As take_memory() without an alignment, but for give_grown(). Large blocks the system moves, and
/// nothing is copied.
std::byte* grow_memory(std::byte* memory, std::size_t held, std::size_t bytes);
/// Gives back what grow_memory() took for so many bytes.
void give_grown(std::byte* memory, std::size_t bytes);

/// Lets the system have what it can of a block, from take_memory(), behind its first bytes: pages. Returns
/// how many of the `held` ones it still has; what is behind them must not be used any more, nor may the block
/// grow.
std::size_t shrink_memory(std::byte* memory, std::size_t held, std::size_t bytes);

/// Where memory comes from in the place of the system.
struct MemorySource {
  /// Null where there is none. `alignment` is a power of two.
  void* (*take)(void* context, std::size_t bytes, std::size_t alignment) = nullptr;
  void (*give)(void* context, void* memory) = nullptr;
  void* context = nullptr;
};

/// All memory comes from there from now on. False, and nothing has changed, once any was taken: one who gets
/// it back must be the one who gave it. Not while another thread takes some.
bool set_memory_source(const MemorySource& source);

/// For tests: the n-th take_memory() from now on fails, once; 0 for none.
void let_memory_fail(std::uint64_t n);

/// A block of memory that is given back. Nearly every source file has one, and <memory> would cost each of
/// them a quarter of a second.
template <class T>
class Memory {
 public:
  Memory() = default;
  explicit Memory(T* block) : block_(block) {}
  Memory(Memory&& other) noexcept : block_(other.release()) {}
  Memory& operator=(Memory&& other) noexcept {
    reset(other.release());
    return *this;
  }
  ~Memory() { give_memory(block_); }

  T* get() const { return block_; }
  /// Gives the block back and has another in its place.
  void reset(T* block = nullptr) { give_memory(std::exchange(block_, block)); }
  /// The block, which the caller gives back from now on.
  [[nodiscard]] T* release() { return std::exchange(block_, nullptr); }

 private:
  T* block_ = nullptr;
};

/// take_memory() for containers, or another function that takes as much.
template <class T, std::byte* (*kTake)(std::size_t, std::size_t) = take_memory>
struct Allocator {
  using value_type = T;
  template <class Other>
  struct rebind {  // NOLINT(readability-identifier-naming): the standard's name
    using other = Allocator<Other, kTake>;
  };

  Allocator() = default;
  template <class Other>
  Allocator(const Allocator<Other, kTake>&) {}

  T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_alloc();
    return reinterpret_cast<T*>(kTake(count * sizeof(T), alignof(T)));
  }
  void deallocate(T* memory, std::size_t) { give_memory(memory); }

  friend bool operator==(const Allocator&, const Allocator&) { return true; }
};

template <class T>
using Vector = std::vector<T, Allocator<T>>;

}  // namespace cellsweep
