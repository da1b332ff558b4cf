/// @file
/// Where large arrays get their memory from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <vector>

namespace cellsweep {

/// Uninitialised memory, 64-byte aligned; a block of some megabytes asks for huge pages: a page fault costs
/// as much as some hundred bodies. Throws std::bad_alloc. Safe to call from any thread.
std::byte* take_memory(std::size_t bytes);
/// More memory, at least for `bytes`, that begins with what was in `memory`, which it replaces; null is fine.
/// As take_memory(), but aligned as any type needs only.
std::byte* grow_memory(std::byte* memory, std::size_t bytes);

void give_memory(void* memory);

/// For tests: the n-th take_memory() from now on fails, once; 0 for none.
void let_memory_fail(std::uint64_t n);

struct GiveMemory {
  void operator()(void* memory) const { give_memory(memory); }
};

/// A block of memory that is given back.
template <class T>
using Memory = std::unique_ptr<T, GiveMemory>;

/// take_memory() for containers.
template <class T>
struct Allocator {
  using value_type = T;

  Allocator() = default;
  template <class Other>
  Allocator(const Allocator<Other>&) {}

  T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_alloc();
    return reinterpret_cast<T*>(take_memory(count * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t) { give_memory(memory); }

  friend bool operator==(const Allocator&, const Allocator&) { return true; }
};

template <class T>
using Vector = std::vector<T, Allocator<T>>;

}  // namespace cellsweep
