/// @file
/// Loads and stores of the host program to problem state areas.
#ifndef SPU_EMU_LIBSPE2_MAPPED_ACCESS_H
#define SPU_EMU_LIBSPE2_MAPPED_ACCESS_H

#include <libspe2-types.h>

namespace spu_emu {

/// From now on loads and stores of 32-bit words to the context's problem state reach its registers: they
/// fault, and a handler of SIGSEGV does what they are for. Other instructions there, and other addresses, are
/// handed on to the handler before it, the former with a line on stderr that says what to call instead.
void map_problem_state(spe_context_ptr_t spe);
void unmap_problem_state(spe_context_ptr_t spe);

}  // namespace spu_emu

#endif
