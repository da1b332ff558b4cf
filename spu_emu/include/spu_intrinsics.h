// The SPU's intrinsics on SSE4.1: every generic spu_ function and the si_ functions, with the SPU's
// semantics.
//
// Each function works on the elements of its argument types exactly as an SPU would: element 0 is leftmost
// and the preferred slot, "even" is the left half of a wider lane, quadword operations and shuffle patterns
// see bytes in big-endian order. A plain cast between vectors of different element width is true to that only
// in sources that add_spu_program compiles (see vec_types.h); `(vec_uchar16)(qword)words` is everywhere.
//
// Floating point: SPU programs run with MXCSR 0xFFC0 on their thread (spu_emu/intrinsics/float_mode.h) and
// are compiled with -frounding-math -ffp-contract=off. SPU_EMU_PRECISE, defined for all of a program's
// sources, makes single precision exact for exponent 255 and for the sign of zero, too, at several times the
// cost. Compile with -msse4.1 at least; AVX2, FMA and AVX-512 are used where the flags allow, with the same
// results. Vectors are also read through pointers to scalars in SDK code: compile SPU sources with
// -fno-strict-aliasing.
#ifndef SPU_EMU_SPU_INTRINSICS_H
#define SPU_EMU_SPU_INTRINSICS_H

#if defined(__x86_64__) && !defined(__SSE4_1__)
#error "spu_intrinsics.h needs SSE4.1: compile with -msse4.1 or for a newer machine"
#endif

#include "vec_types.h"

#ifndef __cplusplus
#include "spu_emu/c/vectors.h"
#else

#include "spu_emu/channels.h"
#include "spu_emu/intrinsics/arithmetic.h"
#include "spu_emu/intrinsics/bits.h"
#include "spu_emu/intrinsics/compare.h"
#include "spu_emu/intrinsics/control.h"
#include "spu_emu/intrinsics/convert.h"
#include "spu_emu/intrinsics/double.h"
#include "spu_emu/intrinsics/estimate.h"
#include "spu_emu/intrinsics/float.h"
#include "spu_emu/intrinsics/float_compare.h"
#include "spu_emu/intrinsics/float_mode.h"
#include "spu_emu/intrinsics/logical.h"
#include "spu_emu/intrinsics/multiply.h"
#include "spu_emu/intrinsics/quadword.h"
#include "spu_emu/intrinsics/qword.h"
#include "spu_emu/intrinsics/scalar.h"
#include "spu_emu/intrinsics/shift.h"
#include "spu_emu/intrinsics/specific_bytes.h"
#include "spu_emu/intrinsics/specific_compare.h"
#include "spu_emu/intrinsics/specific_control.h"
#include "spu_emu/intrinsics/specific_float.h"
#include "spu_emu/intrinsics/specific_integer.h"
#include "spu_emu/intrinsics/specific_memory.h"
#include "spu_emu/intrinsics/specific_scalar.h"
#include "spu_emu/intrinsics/specific_shift.h"

#endif  // __cplusplus

#endif
