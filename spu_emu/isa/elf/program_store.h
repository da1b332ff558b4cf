/// @file
/// The local store of real SPU code: the image of an ELF file in it, the limit it is held to, and what is in
/// use.
#ifndef SPU_EMU_ISA_ELF_PROGRAM_STORE_H
#define SPU_EMU_ISA_ELF_PROGRAM_STORE_H

#include <cstdint>
#include <optional>
#include <string>

#include "isa/elf/elf_loader.h"
#include "mfc/command.h"
#include "mfc/local_store.h"
#include "spe/arena.h"
#include "spu_emu/emulation.h"

namespace spu_emu::isa {

/// What the hardware has, whatever limit a program is held to.
inline constexpr std::uint32_t kHardwareSize = spu_emu::kLocalStoreSize;

/// LS addresses from 0: the image, then heap and stack, which the program shares out itself.
///
/// A limit below 256 KB is held to so: the start-up code's stack pointer is moved down below it, which moves
/// the end of newlib's heap with it; DMA and library calls beyond it are refused; and a store of the
/// program's own beyond it is found at the next stop.
class ProgramStore {
 public:
  /// `observer` learns of every byte that the MFC changes. `arena` and `observer` outlive the store.
  ProgramStore(Arena& arena, const EmulationSettings& settings, StoreObserver& observer);

  /// Clears the local store and puts the program into it. What does not fit, in words, or nothing.
  std::string place(const ElfProgram& program);

  LocalStoreView& view() { return view_; }
  std::byte* bytes() const { return arena_.base(); }
  /// Bytes that the program may use.
  std::uint32_t limit() const { return limit_; }
  std::uint32_t image_end() const { return end_; }
  /// Where the stack begins that the program finds at its start.
  std::uint32_t stack_top() const { return limit_ - kQuadword; }

  /// LS address of a byte beyond the limit that is not zero any more.
  std::optional<std::uint32_t> touched_beyond_limit() const;
  /// The image, and quadwords behind it that are not zero.
  std::uint32_t bytes_in_use() const;
  std::string map() const;

 private:
  static constexpr std::uint32_t kQuadword = 16;

  void lower_stack(std::uint32_t entry);

  Arena& arena_;
  std::uint32_t limit_;
  std::uint32_t stack_reserve_;
  std::uint32_t end_ = 0;
  std::string name_;
  FlatLocalStore view_;
};

}  // namespace spu_emu::isa

#endif
