#include "base/memory/memory.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace cellsweep {
namespace {

/// Larger blocks took longer with huge pages than without, by measurement.
constexpr std::size_t kMostWithHugePages = std::size_t{32} << 20;

std::atomic<std::uint64_t> fails_in = 0;

MemorySource source;
std::atomic<bool> was_taken = false;

bool must_fail() {
  return fails_in.load(std::memory_order_relaxed) != 0 && fails_in.fetch_sub(1) == 1;
}

// The system takes whole pages only.
void ask_for_huge_pages([[maybe_unused]] std::byte* memory, [[maybe_unused]] std::size_t size) {
#ifdef __linux__
  if (size < kHugePage || size > kMostWithHugePages) return;
  const std::size_t before = -reinterpret_cast<std::uintptr_t>(memory) % kHugePage;
  if (before < size) madvise(memory + before, (size - before) / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
}

/// Null where there is none.
void* take_from_system(std::size_t bytes, std::size_t alignment) {
  if (bytes >= kHugePage) alignment = kHugePage;
  void* memory = nullptr;
  if (alignment <= alignof(std::max_align_t)) {
    memory = std::malloc(bytes);
  } else if (posix_memalign(&memory, alignment, bytes) != 0) {
    memory = nullptr;
  }
  if (memory != nullptr) ask_for_huge_pages(static_cast<std::byte*>(memory), bytes);
  return memory;
}

[[gnu::cold]] std::byte* grow_from_source(std::byte* memory, std::size_t held, std::size_t bytes) {
  std::byte* larger = take_memory(bytes);
  std::memcpy(larger, memory, std::min(held, bytes));
  give_memory(memory);
  return larger;
}

}  // namespace

std::byte* take_memory(std::size_t bytes, std::size_t alignment) {
  if (must_fail()) throw std::bad_alloc();
  bytes = std::max(bytes, std::size_t{1});
  if (!was_taken.load(std::memory_order_relaxed)) was_taken.store(true, std::memory_order_relaxed);
  void* memory = source.take == nullptr
                     ? take_from_system(bytes, alignment)
                     : source.take(source.context, bytes, std::max(alignment, alignof(std::max_align_t)));
  if (memory == nullptr) throw std::bad_alloc();
  return static_cast<std::byte*>(memory);
}

std::byte* grow_memory(std::byte* memory, std::size_t held, std::size_t bytes) {
  if (memory == nullptr) return take_memory(bytes);
  if (source.take != nullptr) return grow_from_source(memory, held, bytes);
  if (must_fail()) throw std::bad_alloc();
  auto* larger = static_cast<std::byte*>(std::realloc(memory, bytes));
  if (larger == nullptr) throw std::bad_alloc();
  ask_for_huge_pages(larger, bytes);
  return larger;
}

void give_memory(void* memory) {
  if (source.give == nullptr) return std::free(memory);
  if (memory != nullptr) source.give(source.context, memory);
}

bool set_memory_source(const MemorySource& wanted) {
  if (was_taken) return false;
  source = wanted;
  return true;
}

void let_memory_fail(std::uint64_t n) {
  fails_in = n;
}

}  // namespace cellsweep
