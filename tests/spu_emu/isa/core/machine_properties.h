// What must be true of the machine for any bytes that it is given for a program.
#ifndef SPU_EMU_TESTS_ISA_CORE_MACHINE_PROPERTIES_H
#define SPU_EMU_TESTS_ISA_CORE_MACHINE_PROPERTIES_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace spu_emu::isa {

/// Executes the words at address 0, registers filled from `seed`, one instruction at a time up to a channel
/// instruction (which may wait for ever), a stop or a few thousand instructions, and then the same number at
/// once on a second machine. Both must end in the same state. Gives what is wrong, or nothing.
std::string check_program(std::span<const std::byte> program, std::uint32_t seed);

}  // namespace spu_emu::isa

#endif
