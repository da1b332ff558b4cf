#include "mfc/mapped.h"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>

namespace spu_emu {

namespace {
constexpr std::uint64_t kPage = 4096;

void* address(std::uint64_t of) {
  return reinterpret_cast<void*>(static_cast<std::uintptr_t>(of));
}

/// Linux can be asked since 5.14 whether pages may be read or written, without touching them. Emulators of
/// user processes say yes whatever the page.
bool has_populate() {
  static const bool has = [] {
    alignas(kPage) static std::byte page[kPage];
    return madvise(page, kPage, MADV_POPULATE_WRITE) == 0 && madvise(nullptr, kPage, MADV_POPULATE_READ) != 0;
  }();
  return has;
}

/// Before: whether pages are mapped, some at a time.
bool are_known(std::uint64_t first, std::uint64_t end) {
  constexpr std::uint64_t kPages = 64;
  std::array<unsigned char, kPages> present{};
  for (std::uint64_t at = first; at < end; at += kPages * kPage) {
    const std::uint64_t length = std::min(end - at, kPages * kPage);
    if (mincore(address(at), length, present.data()) != 0 && errno == ENOMEM) return false;
  }
  return true;
}
}  // namespace

bool is_mapped(std::uint64_t first, std::uint64_t size, Access access) {
  const std::uint64_t page = first & ~(kPage - 1);
  const std::uint64_t end = first + size;
  if (end < first || end > UINTPTR_MAX) return false;
  if (!has_populate()) return are_known(page, end);
  const int advice = access == Access::write ? MADV_POPULATE_WRITE : MADV_POPULATE_READ;
  return madvise(address(page), end - page, advice) == 0;
}

}  // namespace spu_emu
