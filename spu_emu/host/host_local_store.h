/// @file
/// The local store of the host engine: an arena, and windows through which a program's own data and stack
/// have LS addresses.
#ifndef SPU_EMU_HOST_HOST_LOCAL_STORE_H
#define SPU_EMU_HOST_HOST_LOCAL_STORE_H

#include <optional>
#include <string>
#include <vector>

#include "host/heap.h"
#include "host/heap_guards.h"
#include "mfc/local_store.h"
#include "spe/arena.h"

namespace spu_emu {

/// Host memory that belongs to a program module: `writable` is data and bss, else constants.
struct ModuleSegment {
  std::byte* first = nullptr;
  std::uint32_t size = 0;
  bool writable = false;
};

/// LS addresses from 0: code reserve (constants have their addresses in it), data and bss, heap, stack
/// reserve.
class HostLocalStore final : public LocalStoreView {
 public:
  /// `code_reserve`, `stack_reserve` in bytes; see EmulationSettings. `arena` outlives the store.
  HostLocalStore(Arena& arena, std::uint32_t code_reserve, std::uint32_t stack_reserve);

  /// Gives a program's segments their addresses and all the rest to the heap. False when data does not fit.
  bool place(const std::vector<ModuleSegment>& segments);
  /// Back to an empty store without windows; LS addresses are then arena addresses throughout.
  void clear();

  std::string why_not(std::uint32_t ls, std::uint32_t size) const override;

  /// LS address of a program's pointer, or of a number that is an LS address or the low half of such a
  /// pointer; nothing when it is no part of the local store.
  std::optional<std::uint32_t> address_of(const volatile void* pointer) const;
  std::uint32_t address_of_number(std::uint32_t number) const;
  /// True for an address on the program's stack below the reserve.
  bool below_stack_reserve(const volatile void* pointer) const;

  Arena& arena() { return arena_; }
  Heap& heap() { return heap_; }
  HeapGuards heap_guards() { return {heap_, arena_.base()}; }
  bool in_arena(const volatile void* pointer) const {
    return reinterpret_cast<std::uintptr_t>(pointer) - reinterpret_cast<std::uintptr_t>(arena_.base()) <
           size();
  }
  std::uint32_t ls_of_arena(const volatile void* pointer) const {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer));
  }
  /// Bytes in use at most: reserves, data and the heap's high water.
  std::uint32_t high_water() const { return fixed_bytes() + heap_.high_water(); }
  /// Several lines: every part with its LS addresses and sizes.
  std::string map() const;

 private:
  struct Window {
    std::uint32_t ls = 0;
    ModuleSegment segment;
  };

  std::byte* at_elsewhere(std::uint32_t ls, std::uint32_t size) noexcept override;
  std::uint32_t size() const { return arena_.local_store_size(); }
  std::uint32_t stack_begin() const { return size() - stack_reserve_; }
  std::uint32_t fixed_bytes() const { return code_reserve_ + data_bytes_ + stack_reserve_; }
  const Window* window_of(std::uint32_t ls) const;

  Arena& arena_;
  Heap heap_;
  std::uint32_t code_reserve_;
  std::uint32_t stack_reserve_;
  std::uint32_t data_bytes_ = 0;
  bool placed_ = false;
  std::vector<Window> windows_;
};

}  // namespace spu_emu

#endif
