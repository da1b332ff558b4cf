/// @file
/// What an instruction word holds beside its opcode and registers, and where it comes from.
#ifndef SPU_EMU_ISA_ENCODING_INSTRUCTION_WORD_H
#define SPU_EMU_ISA_ENCODING_INSTRUCTION_WORD_H

#include <cstddef>
#include <cstdint>

#include "isa/encoding/opcodes.h"
#include "mfc/command.h"

namespace spu_emu::isa {

/// Cuts an address down to that of a word in the local store.
constexpr std::uint32_t kCodeMask = kLocalStoreSize - 4;

/// The value of an instruction's immediate operand, or 0: extended, scaled, and for operands that name a
/// place in the local store its address.
std::int32_t immediate_of(const Instruction& instruction, std::uint32_t word, std::uint32_t pc);

/// The instruction word at `pc`, a multiple of 4 inside the local store.
std::uint32_t fetch(const std::byte* local_store, std::uint32_t pc);

}  // namespace spu_emu::isa

#endif
