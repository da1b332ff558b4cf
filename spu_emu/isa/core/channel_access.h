/// @file
/// Calls of an SPU's channels from its instructions: under the host's floating-point mode, and with the
/// instruction's own address in State::pc, where a Fault finds it.
#ifndef SPU_EMU_ISA_CORE_CHANNEL_ACCESS_H
#define SPU_EMU_ISA_CORE_CHANNEL_ACCESS_H

#include <cstdint>

#include "isa/core/state.h"

namespace spu_emu::isa {

std::uint32_t read_channel(State& state, const Op* op, std::uint32_t channel);
std::uint32_t count_channel(State& state, const Op* op, std::uint32_t channel);
void write_channel(State& state, const Op* op, std::uint32_t channel, std::uint32_t value);

/// The register that keeps where an interrupt came in.
std::uint32_t read_return_address(State& state, const Op* op);

/// Whether an event waits that the program has asked for.
bool is_event_waiting(State& state, const Op* op);

/// Between blocks, interrupts enabled: if an event waits, goes to address 0 as the hardware does.
void take_interrupt(State& state);

}  // namespace spu_emu::isa

#endif
