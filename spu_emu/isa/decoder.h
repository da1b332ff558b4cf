// From instruction words to Ops.
#ifndef SPU_EMU_ISA_DECODER_H
#define SPU_EMU_ISA_DECODER_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "isa/opcodes.h"
#include "isa/state.h"

namespace spu_emu::isa {

/// The value of an instruction's immediate operand, or 0: extended, scaled, and for operands that name a
/// place in the local store its address.
std::int32_t immediate_of(const Instruction& instruction, std::uint32_t word, std::uint32_t pc);

/// The instruction word at `pc`, a multiple of 4 inside the local store.
std::uint32_t fetch(const std::byte* local_store, std::uint32_t pc);

/// The instructions from `pc` on, up to one that never goes on to the next, to `max_instructions`, or to the
/// end of the local store. The last Op always leaves. Gives the number of words they take in `words`. When
/// `timed`, a call of the cycle model goes before each instruction.
std::vector<Op> decode_block(const std::byte* local_store, std::uint32_t pc, std::uint32_t max_instructions,
                             std::uint32_t& words, bool timed = false);

}  // namespace spu_emu::isa

#endif
