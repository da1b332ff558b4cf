/// @file
/// The table of source lines in the debug information of an SPU ELF file.
#ifndef SPU_EMU_ISA_DEBUG_DWARF_LINES_H
#define SPU_EMU_ISA_DEBUG_DWARF_LINES_H

#include <cstddef>
#include <span>
#include <string>

#include "isa/debug/source_lines.h"

namespace spu_emu::isa {

/// The table, or one sentence that says why there is none.
struct DwarfLines {
  SourceLines lines;
  std::string missing;
};

/// Reads it by elfutils' libdw, which is looked for now: who never debugs does not need it.
DwarfLines read_dwarf_lines(std::span<const std::byte> elf_file);

}  // namespace spu_emu::isa

#endif
