/// @file
/// The engines' programs as compiled for a real SPU, where the build had its compiler.
#pragma once

#include <libspe2.h>

namespace cellsweep::cell {

bool has_spu_elf();

/// The handle with the real SPU's program for that with the host's; null for one that has none.
spe_program_handle_t* spu_elf_of(const spe_program_handle_t& program);

}  // namespace cellsweep::cell
