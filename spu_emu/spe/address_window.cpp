#include "spe/address_window.h"

#include <sys/mman.h>

#include <cstdint>
#include <new>

#include "mfc/command.h"
#include "mfc/spe_directory.h"

namespace spu_emu {

namespace {
/// The largest page of any system.
constexpr std::size_t kPage = 64 * 1024;
/// How many windows of its own and others' are looked at for a free one.
constexpr std::uint64_t kCandidates = 4096;

std::byte* reserve(std::byte* wish, std::size_t size) {
  void* given = mmap(wish, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  return given == MAP_FAILED ? nullptr : static_cast<std::byte*>(given);
}

/// Exactly there, or not at all.
bool reserve_at(std::byte* first, std::size_t size) {
  std::byte* given = reserve(first, size);
  if (given == first) return true;
  if (given != nullptr) munmap(given, size);
  return false;
}

/// A window's place below which the system has addresses to give.
std::byte* near_what_the_system_gives() {
  std::byte* given = reserve(nullptr, kPage);
  if (given == nullptr) throw std::bad_alloc();
  munmap(given, kPage);
  return given - reinterpret_cast<std::uintptr_t>(given) % kWindowSize;
}
}  // namespace

AddressWindow::AddressWindow(Extent extent) {
  if (extent == Extent::whole)
    reserve_whole();
  else
    reserve_parts();
}

AddressWindow::~AddressWindow() {
  for (const Part& part : parts_) {
    if (part.size != 0) munmap(part.first, part.size);
  }
}

/// A window aligned to its size, and one page before it, fit into two windows wherever those lie.
void AddressWindow::reserve_whole() {
  std::byte* reserved = reserve(nullptr, 2 * kWindowSize);
  if (reserved == nullptr) throw std::bad_alloc();
  parts_[0] = {reserved, 2 * kWindowSize};
  base_ = reserved + (kWindowSize - reinterpret_cast<std::uintptr_t>(reserved) % kWindowSize);
}

void AddressWindow::reserve_parts() {
  std::byte* const near = near_what_the_system_gives();
  for (std::uint64_t k = 1; k <= kCandidates; ++k) {
    if (reserve_parts_at(near - k * kWindowSize)) return;
  }
  throw std::bad_alloc();
}

bool AddressWindow::reserve_parts_at(std::byte* base) {
  const Part store{base - kPage, kPage + kLocalStoreSize + kPage};
  const Part problem_state{base + kProblemStateOffset, kProblemStateSize};
  if (!reserve_at(store.first, store.size)) return false;
  if (!reserve_at(problem_state.first, problem_state.size)) {
    munmap(store.first, store.size);
    return false;
  }
  parts_ = {store, problem_state};
  base_ = base;
  return true;
}

}  // namespace spu_emu
