/// @file
/// Instruction words as assembler text.
#ifndef SPU_EMU_ISA_ENCODING_DISASSEMBLER_H
#define SPU_EMU_ISA_ENCODING_DISASSEMBLER_H

#include <cstdint>
#include <string>

namespace spu_emu::isa {

/// As GNU objdump prints an image without symbols: mnemonic, tab, operands, and numbers above 16 again in
/// hexadecimal behind "# ". Words that encode nothing are ".long". `pc` makes relative addresses absolute.
std::string disassemble(std::uint32_t instruction, std::uint32_t pc);

}  // namespace spu_emu::isa

#endif
