#include "spe/arena.h"

#include <sys/mman.h>

#include <algorithm>
#include <new>

#include "mfc/command.h"

namespace spu_emu {

namespace {
// To reserve a whole window takes an emulator of a user's processes, which keeps account of every page, a
// tenth of a second; only programs compiled for this machine need it.
#ifdef SPU_EMU_HOST_ENGINE
constexpr bool kHasStack = true;
constexpr auto kExtent = AddressWindow::Extent::whole;
constexpr std::uint32_t kMostBytes = UINT32_MAX;
#else
constexpr bool kHasStack = false;
constexpr auto kExtent = AddressWindow::Extent::parts;
constexpr std::uint32_t kMostBytes = kLocalStoreSize;
#endif

void allow(std::byte* first, std::size_t size) {
  if (mprotect(first, size, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
}
}  // namespace

Arena::Arena(std::uint32_t local_store_size)
    : window_(kExtent), local_store_size_(std::min(local_store_size, kMostBytes)) {
  allow(base(), local_store_size_);
  if (kHasStack) allow(stack(), kStackSize);
}

void Arena::make_accessible(std::uint32_t size) {
  if (size > local_store_size_) allow(base(), size);
}

}  // namespace spu_emu
