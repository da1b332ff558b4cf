// The intrinsics in C, and the casts. Read, for its macros alone, when a source is preprocessed already: no
// argument has a comma of its own any more. Each macro evaluates its arguments once.
#ifndef SPU_EMU_C_INTRINSIC_MACROS_H
#define SPU_EMU_C_INTRINSIC_MACROS_H

#include "spu_emu/c/casts.h"
#include "spu_emu/c/control.h"
#include "spu_emu/c/intrinsic_choice.h"

#endif
