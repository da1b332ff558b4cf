/// @file
/// The engines' programs as compiled for a real SPU, where the build had its compiler.
#pragma once

#include <libspe2.h>

namespace cellsweep::cell {

bool has_spu_elf();

/// Whether there are no others: this build is for a processor that spu_emu has no vectors for.
bool has_only_spu_elf();

/// The handle with the real SPU's program for that with the host's; null for one that has none. Where
/// programs are built for the real SPU only, the same handle.
spe_program_handle_t* spu_elf_of(spe_program_handle_t& program);

}  // namespace cellsweep::cell
