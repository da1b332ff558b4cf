/// @file
/// Reads the variables in the debug information of an SPU ELF file.
#ifndef SPU_EMU_ISA_DEBUG_DWARF_VARIABLES_H
#define SPU_EMU_ISA_DEBUG_DWARF_VARIABLES_H

#include "isa/debug/libdw.h"
#include "isa/debug/variables.h"

namespace spu_emu::isa {

/// What is broken is left out.
Variables read_variables(const Libdw& dw, Dwarf* dwarf);

}  // namespace spu_emu::isa

#endif
