/// @file
/// Main memory that DMA reads and writes: whole lines of 128 bytes.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
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

/// Zeros for DMA to write over, much more than is written as a rule: pages that the system has to give only
/// where they are written. The C library's memory may have been another's before, and tools that watch memory
/// go through all of it. Behind the last line lies what nobody may touch, so that a transfer beyond is
/// refused.
class DmaPages {
 public:
  /// Throws std::bad_alloc.
  explicit DmaPages(std::size_t bytes) {
    const std::size_t lines = (bytes + kDmaAlign - 1) / kDmaAlign * kDmaAlign;
    const std::size_t pages = (lines + kPage - 1) / kPage * kPage;
    mapped_ = pages + kPage;
    void* first = mmap(nullptr, mapped_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (first == MAP_FAILED) throw std::bad_alloc();
    first_ = static_cast<std::byte*>(first);
    memory_ = first_ + (pages - lines);
    if (mprotect(first_ + pages, kPage, PROT_NONE) == 0) return;
    munmap(first_, mapped_);
    throw std::bad_alloc();
  }
  DmaPages(DmaPages&& other) noexcept
      : first_(std::exchange(other.first_, nullptr)), memory_(other.memory_), mapped_(other.mapped_) {}
  DmaPages& operator=(DmaPages&&) = delete;
  ~DmaPages() {
    if (first_ != nullptr) munmap(first_, mapped_);
  }

  void* get() const { return memory_; }

 private:
  /// The largest page of any system that has SPEs, emulated or not.
  static constexpr std::size_t kPage = std::size_t{64} << 10;

  std::byte* first_;
  std::byte* memory_;
  std::size_t mapped_;
};

inline WireAddress wire_address(const void* memory) {
  const auto number = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(memory));
  return {static_cast<std::uint32_t>(number >> 32), static_cast<std::uint32_t>(number)};
}

}  // namespace cellsweep::cell
