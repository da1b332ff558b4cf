/// @file
/// From instruction words to blocks of Ops.
#ifndef SPU_EMU_ISA_CORE_DECODER_H
#define SPU_EMU_ISA_CORE_DECODER_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "isa/core/state.h"

namespace spu_emu::isa {

/// The instructions from `pc` on, up to one that never goes on to the next, to `max_instructions`, or to the
/// end of the local store. The last Op always leaves. Gives the number of words they take in `words`. When
/// `observed`, a call of the observer goes before each instruction; a call of `traps`, which may be null,
/// goes before each that these want.
std::vector<Op> decode_block(const std::byte* local_store, std::uint32_t pc, std::uint32_t max_instructions,
                             std::uint32_t& words, bool observed = false,
                             const InstructionTraps* traps = nullptr);

}  // namespace spu_emu::isa

#endif
