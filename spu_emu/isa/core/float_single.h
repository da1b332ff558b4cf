/// @file
/// Single-precision results bit for bit, with the flags that the FPSCR collects for them.
#ifndef SPU_EMU_ISA_CORE_FLOAT_SINGLE_H
#define SPU_EMU_ISA_CORE_FLOAT_SINGLE_H

#include "spu_emu/intrinsics/float.h"

namespace spu_emu::isa {

/// Flags of a slot, in the low bits of its word of the FPSCR.
constexpr unsigned kOverflow = 4;
constexpr unsigned kUnderflow = 2;
constexpr unsigned kDifferent = 1;  // from what IEEE arithmetic gives: exponent 255, denormals, underflow

struct SingleResult {
  vec_float4 value;
  vec_uint4 flags;
};

/// All of them need the SPU's MXCSR (intrinsics/float_mode.h).
SingleResult add_single(vec_float4 a, vec_float4 b);
SingleResult subtract_single(vec_float4 a, vec_float4 b);
SingleResult multiply_single(vec_float4 a, vec_float4 b);
/// a * b + c, rounded once.
SingleResult multiply_add_single(vec_float4 a, vec_float4 b, vec_float4 c);

}  // namespace spu_emu::isa

#endif
