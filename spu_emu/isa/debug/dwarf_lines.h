/// @file
/// The tables of source lines and variables in the debug information of an SPU ELF file.
#ifndef SPU_EMU_ISA_DEBUG_DWARF_LINES_H
#define SPU_EMU_ISA_DEBUG_DWARF_LINES_H

#include <cstddef>
#include <span>
#include <string>

#include "isa/debug/source_lines.h"
#include "isa/debug/variables.h"

namespace spu_emu::isa {

/// The tables, or one sentence that says why there are none.
struct DwarfLines {
  SourceLines lines;
  Variables variables;
  std::string missing;
};

/// Reads them by elfutils' libdw, which is looked for now: who never debugs does not need it.
DwarfLines read_dwarf_lines(std::span<const std::byte> elf_file);

}  // namespace spu_emu::isa

#endif
