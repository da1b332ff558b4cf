/// @file
/// What is written into the guards behind the blocks of a heap, to see whether a program wrote beyond a
/// block.
#ifndef SPU_EMU_HOST_HEAP_GUARDS_H
#define SPU_EMU_HOST_HEAP_GUARDS_H

#include <cstddef>
#include <cstdint>
#include <optional>

#include "host/heap.h"

namespace spu_emu {

/// Something was written to LS address `at`, behind the `asked` bytes of a block.
struct HeapOverrun {
  std::uint32_t block;  ///< where the block begins
  std::uint32_t asked;
  std::uint32_t at;
};

/// The guards of `heap`, in memory where LS address 0 is at `base`; both outlive it.
class HeapGuards {
 public:
  HeapGuards(const Heap& heap, std::byte* base) : heap_(heap), base_(base) {}

  /// Marks the guard of the block that begins at `ls`, when it has one, and all guards.
  void mark(std::uint32_t ls) const;
  void mark_all() const;

  /// Whether something was written into the guard of the block that begins at `ls`, and into any.
  std::optional<HeapOverrun> overrun_of(std::uint32_t ls) const;
  std::optional<HeapOverrun> any_overrun() const;

 private:
  void mark(const Heap::Guard& guard) const;
  std::optional<HeapOverrun> overrun_of(const Heap::Guard& guard) const;

  const Heap& heap_;
  std::byte* base_;
};

}  // namespace spu_emu

#endif
