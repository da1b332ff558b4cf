/// @file
/// A table of source lines as text, which one program writes for another that cannot read DWARF.
#ifndef SPU_EMU_ISA_DEBUG_LINE_TABLE_TEXT_H
#define SPU_EMU_ISA_DEBUG_LINE_TABLE_TEXT_H

#include <istream>
#include <string>

#include "isa/debug/source_lines.h"

namespace spu_emu::isa {

/// "file PATH" before the first row of a file and wherever another one follows; a row is its address in
/// hexadecimal, its line, and "statement", "inside" or "end".
std::string line_table_text(const SourceLines& lines);

/// The table again, without what is broken.
SourceLines read_line_table(std::istream& text);

}  // namespace spu_emu::isa

#endif
