#include "tools/guest_memory.h"

#include <sys/mman.h>

#include <new>

namespace spu_emu {

namespace {
/// As much as the largest list moves, and a multiple of every page size.
constexpr std::size_t kGuard = std::size_t{1} << 20U;
}  // namespace

GuestMemory::GuestMemory()
    : mapping_(mmap(nullptr, kGuard + kSize + kGuard, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
                    -1, 0)),
      words_(nullptr) {
  if (mapping_ == MAP_FAILED) throw std::bad_alloc();
  std::byte* const first = static_cast<std::byte*>(mapping_) + kGuard;
  if (mprotect(first, kSize, PROT_READ | PROT_WRITE) != 0) {
    munmap(mapping_, kGuard + kSize + kGuard);
    throw std::bad_alloc();
  }
  words_ = reinterpret_cast<std::uint32_t*>(first);
}

GuestMemory::~GuestMemory() {
  munmap(mapping_, kGuard + kSize + kGuard);
}

}  // namespace spu_emu
