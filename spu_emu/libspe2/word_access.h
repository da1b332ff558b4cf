/// @file
/// The instruction at which a signal found a thread, where it loads or stores a word.
#ifndef SPU_EMU_LIBSPE2_WORD_ACCESS_H
#define SPU_EMU_LIBSPE2_WORD_ACCESS_H

#include <cstdint>
#include <optional>

namespace spu_emu {

/// A load into a register, or a store of `value`.
struct WordAccess {
  bool is_store = false;
  std::uint32_t value = 0;
  unsigned target = 0;
  bool is_signed = false;
  unsigned size = 4;
};

/// `context` is a signal handler's. Nothing for every other instruction, and on processors that are not
/// known.
std::optional<WordAccess> word_access_of(const void* context);
/// Goes on behind the instruction; a load got `value`.
void finish_access(void* context, const WordAccess& access, std::uint32_t value);

}  // namespace spu_emu

#endif
