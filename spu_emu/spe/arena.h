/// @file
/// The address space of one emulated SPE: its local store, its program's stack, its problem state.
#ifndef SPU_EMU_SPE_ARENA_H
#define SPU_EMU_SPE_ARENA_H

#include <cstddef>
#include <cstdint>

#include "spe/address_window.h"

namespace spu_emu {

/// 4 GB of addresses from a multiple of 4 GB, so that the low 32 bits of a pointer into the local store are
/// its LS address. The local store lies at the start with an unreadable page before and behind it, the stack
/// of programs compiled for this machine ends at kStackTop; everything else cannot be accessed. Where only
/// real SPU code runs there is no stack, a local store is at most as large as a real one, and what lies
/// between may be anybody's. Throws std::bad_alloc when the system gives no memory.
class Arena {
 public:
  static constexpr std::uint32_t kStackTop = 0x80000000U;
  static constexpr std::uint32_t kStackSize = 1U << 20U;

  explicit Arena(std::uint32_t local_store_size);
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  /// Makes at least `size` bytes from the base accessible, whatever the local store's size. Throws as above.
  void make_accessible(std::uint32_t size);

  std::byte* base() const { return window_.base(); }
  std::uint32_t local_store_size() const { return local_store_size_; }
  std::byte* stack() const { return base() + kStackTop - kStackSize; }
  std::byte* stack_top() const { return base() + kStackTop; }

 private:
  AddressWindow window_;
  std::uint32_t local_store_size_;
};

}  // namespace spu_emu

#endif
