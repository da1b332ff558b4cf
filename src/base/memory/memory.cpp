#include "base/memory/memory.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>

#include "base/memory/regions.h"
#include "base/sanitized.h"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace cellsweep {
namespace {

/// Larger blocks took longer with huge pages than without, by measurement, where they are written and read
/// once: Xeon, four million new bodies, 1.2 times as long.
constexpr std::size_t kMostWithHugePages = std::size_t{32} << 20;

std::atomic<std::uint64_t> fails_in = 0;

MemorySource source;
std::atomic<bool> was_taken = false;

bool must_fail() {
  return fails_in.load(std::memory_order_relaxed) != 0 && fails_in.fetch_sub(1) == 1;
}

#ifdef __linux__

/// Blocks that grow are mappings of their own from this size on. Of smaller ones there may be memory whose
/// pages are there already, which takes less than to have them moved once.
constexpr std::size_t kMapped = regions::kMost;

bool is_mapped(std::size_t bytes) {
  return bytes >= kMapped;
}

std::size_t page_size() {
  return static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::size_t in_pages(std::size_t bytes) {
  const std::size_t page = page_size();
  if (bytes > std::numeric_limits<std::size_t>::max() - page) throw std::bad_alloc();
  return (bytes + page - 1) / page * page;
}

/// For all pages that the memory lies in: where some of a mapping were left out, the system would not move it
/// when it grows.
void ask_for_huge_pages(void* memory, std::size_t size, std::size_t most = kMostWithHugePages) {
  if (size < kHugePage || size > most) return;
  const std::size_t before = reinterpret_cast<std::uintptr_t>(memory) % page_size();
  madvise(static_cast<std::byte*>(memory) - before, in_pages(before + size), MADV_HUGEPAGE);
}

/// Null where there is none.
[[gnu::cold]] void* grow_mapped(std::byte* memory, std::size_t held, std::size_t bytes) {
  const std::size_t size = in_pages(bytes);
  void* larger = is_mapped(held)
                     ? mremap(memory, in_pages(held), size, MREMAP_MAYMOVE)
                     : mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (larger == MAP_FAILED) return nullptr;
  if (memory == nullptr || is_mapped(held)) return larger;
  ask_for_huge_pages(larger, bytes);
  std::memcpy(larger, memory, held);
  give_memory(memory);
  return larger;
}

void give_mapped(std::byte* memory, std::size_t bytes) {
  munmap(memory, in_pages(bytes));
}

/// How many bytes are held on to.
std::size_t give_pages(std::byte* memory, std::size_t held, std::size_t bytes) {
  const std::size_t page = page_size();
  const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + bytes + page - 1) / page * page;
  const std::uintptr_t last = (begin + held) / page * page;
  if (first >= last || madvise(memory + (first - begin), last - first, MADV_DONTNEED) != 0) return held;
  return first - begin;
}

#else

bool is_mapped(std::size_t) {
  return false;
}
void ask_for_huge_pages(void*, std::size_t, std::size_t = 0) {}
void* grow_mapped(std::byte*, std::size_t, std::size_t) {
  return nullptr;
}
void give_mapped(std::byte*, std::size_t) {}
std::size_t give_pages(std::byte*, std::size_t held, std::size_t) {
  return held;
}

#endif

void note_taking() {
  if (must_fail()) throw std::bad_alloc();
  if (!was_taken.load(std::memory_order_relaxed)) was_taken.store(true, std::memory_order_relaxed);
}

/// Sanitizers know where blocks of the C library end.
bool is_for_regions(std::size_t bytes) {
  return !kIsSanitized && bytes >= regions::kLeast && bytes <= regions::kMost;
}

/// Null where there is none.
void* take_from_system(std::size_t bytes, std::size_t alignment) {
  if (is_for_regions(bytes)) {
    if (void* const memory = regions::take(bytes)) return memory;
  }
  if (bytes >= kHugePage) alignment = kHugePage;
  void* memory = nullptr;
  if (alignment <= alignof(std::max_align_t)) {
    memory = std::malloc(bytes);
  } else if (posix_memalign(&memory, alignment, bytes) != 0) {
    memory = nullptr;
  }
  if (memory != nullptr) ask_for_huge_pages(memory, bytes);
  return memory;
}

/// To less than kMapped. Null where there is none.
[[gnu::cold]] void* grow_unmapped(std::byte* memory, std::size_t held, std::size_t bytes) {
  if (!is_for_regions(bytes)) return std::realloc(memory, std::max(bytes, std::size_t{1}));
  if (regions::resize(memory, bytes)) return memory;
  void* const larger = take_from_system(bytes, 1);
  if (larger == nullptr || memory == nullptr) return larger;
  std::memcpy(larger, memory, std::min(held, bytes));
  give_memory(memory);
  return larger;
}

[[gnu::cold]] std::byte* grow_from_source(std::byte* memory, std::size_t held, std::size_t bytes) {
  std::byte* larger = take_memory(bytes);
  if (memory != nullptr) std::memcpy(larger, memory, std::min(held, bytes));
  give_memory(memory);
  return larger;
}

}  // namespace

std::byte* take_memory(std::size_t bytes, std::size_t alignment) {
  note_taking();
  bytes = std::max(bytes, std::size_t{1});
  void* memory = source.take == nullptr
                     ? take_from_system(bytes, alignment)
                     : source.take(source.context, bytes, std::max(alignment, alignof(std::max_align_t)));
  if (memory == nullptr) throw std::bad_alloc();
  return static_cast<std::byte*>(memory);
}

std::byte* take_huge_pages(std::size_t bytes, std::size_t alignment) {
  std::byte* const memory = take_memory(bytes, alignment);
  if (source.take == nullptr) ask_for_huge_pages(memory, bytes, std::numeric_limits<std::size_t>::max());
  return memory;
}

std::byte* grow_memory(std::byte* memory, std::size_t held, std::size_t bytes) {
  if (source.take != nullptr) return grow_from_source(memory, held, bytes);
  note_taking();
  void* const larger =
      is_mapped(bytes) ? grow_mapped(memory, held, bytes) : grow_unmapped(memory, held, bytes);
  if (larger == nullptr) throw std::bad_alloc();
  ask_for_huge_pages(larger, bytes);
  return static_cast<std::byte*>(larger);
}

void give_grown(std::byte* memory, std::size_t bytes) {
  if (source.give != nullptr || !is_mapped(bytes)) return give_memory(memory);
  give_mapped(memory, bytes);
}

std::size_t shrink_memory(std::byte* memory, std::size_t held, std::size_t bytes) {
  if (source.take != nullptr) return held;
  const std::size_t kept = give_pages(memory, held, bytes);
  regions::resize(memory, kept);
  return kept;
}

void give_memory(void* memory) {
  if (source.give == nullptr) {
    if (!regions::give(memory)) std::free(memory);
    return;
  }
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
