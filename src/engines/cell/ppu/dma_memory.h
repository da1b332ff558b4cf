/// @file
/// Main memory that DMA reads and writes: whole lines of 128 bytes.
#pragma once

#include <cstdint>
#include <new>
#include <vector>

#include "engines/cell/wire.h"

namespace cellsweep::cell {

/// Gives out memory that begins at a DMA line.
template <class T>
struct DmaAllocator {
  using value_type = T;

  DmaAllocator() = default;
  template <class U>
  explicit DmaAllocator(const DmaAllocator<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = (count * sizeof(T) + kDmaAlign - 1) / kDmaAlign * kDmaAlign;
    return static_cast<T*>(::operator new (bytes, std::align_val_t{kDmaAlign}));
  }
  void deallocate(T* memory, std::size_t) { ::operator delete (memory, std::align_val_t{kDmaAlign}); }

  friend bool operator==(const DmaAllocator&, const DmaAllocator&) { return true; }
};

/// A vector that a transfer may begin at; the bytes up to the end of its last line belong to it too.
template <class T>
using DmaVector = std::vector<T, DmaAllocator<T>>;

inline WireAddress wire_address(const void* memory) {
  const auto number = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(memory));
  return {static_cast<std::uint32_t>(number >> 32), static_cast<std::uint32_t>(number)};
}

}  // namespace cellsweep::cell
