#include "libspe2/arena.h"

#include <sys/mman.h>

#include <new>

namespace spu_emu {

namespace {
constexpr std::uint64_t kWindow = std::uint64_t{1} << 32U;

void allow(std::byte* first, std::size_t size) {
  if (mprotect(first, size, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
}
}  // namespace

Arena::Arena(std::uint32_t local_store_size) : local_store_size_(local_store_size) {
  // A window aligned to its size, and one page before it, fit into two windows wherever those lie.
  void* reserved = mmap(nullptr, 2 * kWindow, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (reserved == MAP_FAILED) throw std::bad_alloc();
  reservation_ = static_cast<std::byte*>(reserved);
  const auto first = reinterpret_cast<std::uintptr_t>(reservation_);
  base_ = reservation_ + ((first / kWindow + 1) * kWindow - first);
  try {
    allow(base_, local_store_size_);
    allow(stack(), kStackSize);
  } catch (...) {
    munmap(reservation_, 2 * kWindow);
    throw;
  }
}

void Arena::make_accessible(std::uint32_t size) {
  if (size > local_store_size_) allow(base_, size);
}

Arena::~Arena() {
  munmap(reservation_, 2 * kWindow);
}

}  // namespace spu_emu
