// A tiny assembler for tests: encodes instructions by the table of opcodes, with operands as the real one
// takes them.
#ifndef SPU_EMU_TESTS_ISA_ENCODING_ASSEMBLER_H
#define SPU_EMU_TESTS_ISA_ENCODING_ASSEMBLER_H

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

namespace spu_emu::isa {

/// The word of one instruction. Operands in the assembler's order: numbers of registers, channels and special
/// registers, immediates, and for addresses the distance (relative) or the address (absolute) in bytes.
/// Throws std::invalid_argument for names and counts of operands that do not exist.
std::uint32_t encode(std::string_view mnemonic, std::initializer_list<std::int32_t> operands = {});
std::uint32_t encode(std::string_view mnemonic, std::span<const std::int32_t> operands);

/// The word with bits ORed in: the interrupt bits of branches, the code of a stop.
constexpr std::uint32_t kInterruptsOn = 1U << 18U;
constexpr std::uint32_t kInterruptsOff = 1U << 19U;

}  // namespace spu_emu::isa

#endif
