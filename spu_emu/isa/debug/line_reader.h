/// @file
/// The source lines of a program, read here or by another program.
#ifndef SPU_EMU_ISA_DEBUG_LINE_READER_H
#define SPU_EMU_ISA_DEBUG_LINE_READER_H

#include "isa/debug/dwarf_lines.h"

namespace spu_emu::isa {

/// By libdw; where that is not there, by the command that SPU_EMU_LINE_READER in the environment names, if it
/// does: it gets the name of an ELF file behind it and prints the table (line_table_text.h), as `spu-run
/// --list-lines` does. So a program for a machine without libdw (PowerPC) has lines, too.
DwarfLines read_lines(std::span<const std::byte> elf_file);

}  // namespace spu_emu::isa

#endif
