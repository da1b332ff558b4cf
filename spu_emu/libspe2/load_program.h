/// @file
/// Chooses the engine for a program image.
#ifndef SPU_EMU_LIBSPE2_LOAD_PROGRAM_H
#define SPU_EMU_LIBSPE2_LOAD_PROGRAM_H

#include "spe/program_loader.h"

namespace spu_emu {

/// Loads an x86-64 module for the host engine, an SPU ELF file for the instruction-level engine.
LoadResult load_program(Spe& spe, const ProgramImage& image);

}  // namespace spu_emu

#endif
