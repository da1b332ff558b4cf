/// @file
/// What an instruction is about to do, as far as a debugger stops for it.
#ifndef SPU_EMU_ISA_DEBUG_INSTRUCTION_EFFECTS_H
#define SPU_EMU_ISA_DEBUG_INSTRUCTION_EFFECTS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "isa/core/machine.h"

namespace spu_emu::isa {

/// A store of a quadword: where, and what in the SPU's byte order.
struct StoreEffect {
  std::uint32_t address = 0;
  std::array<std::byte, 16> bytes{};
};

/// A channel instruction. Counts are neither read nor write.
struct ChannelEffect {
  std::uint32_t channel = 0;
  bool write = false;
  std::uint32_t value = 0;  // of a write
};

bool is_store_instruction(std::uint32_t word);
/// Calls link through r0; a branch that links another register only wants its own address.
bool is_call_instruction(std::uint32_t word);

/// Of the instruction `word` at `pc`, with the registers as they are now.
std::optional<StoreEffect> store_effect(std::uint32_t word, std::uint32_t pc, const Machine& machine);
std::optional<ChannelEffect> channel_effect(std::uint32_t word);
/// The same with the value that a write has.
std::optional<ChannelEffect> channel_effect(std::uint32_t word, const Machine& machine);

}  // namespace spu_emu::isa

#endif
