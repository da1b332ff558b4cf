// Chooses the engine for a program image.
#ifndef SPU_EMU_LIBSPE2_LOAD_PROGRAM_H
#define SPU_EMU_LIBSPE2_LOAD_PROGRAM_H

#include <libspe2-types.h>

#include <memory>
#include <string>

#include "libspe2/program.h"

namespace spu_emu {

class Spe;

/// What came of loading: a program, or an errno value and the reason.
struct LoadResult {
  std::unique_ptr<Program> program;
  int error = 0;
  std::string reason;
};

/// Loads an x86-64 module for the host engine, an SPU ELF file for the instruction-level engine. The program
/// refers to `spe`, which outlives it.
LoadResult load_program(Spe& spe, const spe_program_handle_t& handle);

}  // namespace spu_emu

#endif
