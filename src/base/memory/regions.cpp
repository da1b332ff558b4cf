#include "base/memory/regions.h"

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <new>
#include <utility>

#include "base/memory/memory.h"
#include "base/memory/piece_runs.h"

#ifdef __linux__
#include <pthread.h>
#include <sys/mman.h>
#endif

namespace cellsweep::regions {

#ifdef __linux__

namespace {

constexpr std::size_t kPiece = kHugePage / PieceRuns::kPiecesOfPage;
constexpr std::size_t kRegion = kPiece * PieceRuns::kPieces;
/// More than two gigabytes of such blocks are the C library's.
constexpr std::size_t kMostRegions = 64;
static_assert(kAskedAtOnce == kRegion + kHugePage);
constexpr std::uint32_t kPagesIdle = kMostIdle / kHugePage;

/// Lies at the beginning of its own first page, and gives out what is behind itself.
class Region {
 public:
  Region() { runs_.take(pieces_of(sizeof(Region)), 1); }

  std::byte* begin() { return reinterpret_cast<std::byte*>(this); }
  bool has(const void* memory) const {
    return reinterpret_cast<std::uintptr_t>(memory) - reinterpret_cast<std::uintptr_t>(this) < kRegion;
  }

  static std::uint32_t pieces_of(std::size_t bytes) {
    return bytes == 0 ? 1 : static_cast<std::uint32_t>((bytes + kPiece - 1) / kPiece);
  }

  std::byte* take(std::size_t bytes) {
    const std::uint32_t unit = bytes < kHugePage ? 1 : PieceRuns::kPiecesOfPage;
    const std::uint32_t first = runs_.take(pieces_of(bytes), unit);
    if (first == PieceRuns::kPieces) return nullptr;
    ++blocks_;
    return begin() + first * kPiece;
  }
  bool resize(const std::byte* memory, std::size_t bytes) {
    return runs_.resize(first_of(memory), pieces_of(bytes));
  }
  void give(const void* memory) {
    --blocks_;
    runs_.give(first_of(memory));
  }
  bool is_empty() const { return blocks_ == 0; }

  /// Whether the block is in the first page, which is never idle.
  bool is_in_first_page(const void* memory) const {
    return runs_.end_of(first_of(memory)) <= PieceRuns::kPiecesOfPage;
  }
  /// Looks which pages are idle now: there, and nothing is in them. Returns how many more than before.
  int note_idle() {
    const int before = std::popcount(idle_);
    const std::uint32_t free = runs_.free_pages();
    there_ |= ~free;
    idle_ = there_ & free;
    return std::popcount(idle_) - before;
  }
  /// Gives one of those to the system; false when there is none.
  bool drop_idle() {
    if (idle_ == 0) return false;
    const auto page = static_cast<unsigned>(std::bit_width(idle_) - 1);
    madvise(begin() + page * kHugePage, kHugePage, MADV_DONTNEED);
    there_ &= ~(1U << page);
    idle_ &= ~(1U << page);
    return true;
  }

 private:
  std::uint32_t first_of(const void* memory) const {
    const auto* const first = reinterpret_cast<const std::byte*>(this);
    return static_cast<std::uint32_t>((static_cast<const std::byte*>(memory) - first) / kPiece);
  }

  PieceRuns runs_;
  std::uint32_t blocks_ = 0;
  std::uint32_t there_ = 0;  // pages that the system may have given
  std::uint32_t idle_ = 0;
};

pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
std::array<Region*, kMostRegions> regions{};
std::atomic<std::size_t> count = 0;
int idle = 0;  // pages of all
bool is_told_of_forks = false;

void lock() {
  pthread_mutex_lock(&mutex);
}
void unlock() {
  pthread_mutex_unlock(&mutex);
}

struct Locked {
  Locked() { lock(); }
  ~Locked() { unlock(); }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;
};

Region* find(const void* memory) {
  const std::size_t known = count.load(std::memory_order_acquire);
  for (std::size_t i = 0; i < known; ++i)
    if (regions[i]->has(memory)) return regions[i];
  return nullptr;
}

void* map_aligned() {
  void* const memory =
      mmap(nullptr, kAskedAtOnce, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return nullptr;
  auto* const begin = static_cast<std::byte*>(memory);
  const std::size_t before = (kHugePage - reinterpret_cast<std::uintptr_t>(begin) % kHugePage) % kHugePage;
  if (before > 0) munmap(begin, before);
  munmap(begin + before + kRegion, kHugePage - before);
  return begin + before;
}

// The first page of all is in small ones: who needs little is not to have two megabytes cleared for it.
[[gnu::cold]] Region* add_region() {
  const std::size_t known = count.load(std::memory_order_relaxed);
  if (known == kMostRegions) return nullptr;
  void* const memory = map_aligned();
  if (memory == nullptr) return nullptr;
  // A child of fork() must find the mutex as nobody's.
  if (!std::exchange(is_told_of_forks, true)) pthread_atfork(lock, unlock, unlock);
  const std::size_t small = known == 0 ? kHugePage : 0;
  madvise(static_cast<std::byte*>(memory) + small, kRegion - small, MADV_HUGEPAGE);
  regions[known] = new (memory) Region;
  count.store(known + 1, std::memory_order_release);
  return regions[known];
}

void drop_what_is_too_much(Region& region) {
  idle += region.note_idle();
  while (idle > static_cast<int>(kPagesIdle) && region.drop_idle()) --idle;
}

/// A library that is unloaded leaves nothing behind. What somebody still has stays, and so do all regions
/// then.
struct Unload {
  Unload() = default;
  [[gnu::cold]] ~Unload() {
    const Locked locked;
    const std::size_t known = count.load(std::memory_order_relaxed);
    for (std::size_t i = 0; i < known; ++i)
      if (!regions[i]->is_empty()) return;
    count.store(0, std::memory_order_relaxed);
    idle = 0;
    for (std::size_t i = 0; i < known; ++i) munmap(regions[i], kRegion);
  }
  Unload(const Unload&) = delete;
  Unload& operator=(const Unload&) = delete;
};

Unload at_the_end;

}  // namespace

std::byte* take(std::size_t bytes) {
  const Locked locked;
  for (std::size_t i = 0;; ++i) {
    Region* const region = i < count.load(std::memory_order_relaxed) ? regions[i] : add_region();
    if (region == nullptr) return nullptr;
    if (std::byte* const memory = region->take(bytes)) {
      if (!region->is_in_first_page(memory)) idle += region->note_idle();
      return memory;
    }
  }
}

bool resize(std::byte* memory, std::size_t bytes) {
  Region* const region = find(memory);
  if (region == nullptr) return false;
  const Locked locked;
  const bool is_resized = region->resize(memory, bytes);
  drop_what_is_too_much(*region);
  return is_resized;
}

bool give(void* memory) {
  Region* const region = find(memory);
  if (region == nullptr) return false;
  const Locked locked;
  const bool is_in_first_page = region->is_in_first_page(memory);
  region->give(memory);
  if (!is_in_first_page) drop_what_is_too_much(*region);
  return true;
}

#else

std::byte* take(std::size_t) {
  return nullptr;
}
bool resize(std::byte*, std::size_t) {
  return false;
}
bool give(void*) {
  return false;
}

#endif

}  // namespace cellsweep::regions
