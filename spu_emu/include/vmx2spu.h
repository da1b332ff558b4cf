// The PPU's AltiVec functions (vec_) for SPU programs, bit for bit as the SDK's header computes them, also
// where AltiVec has another result.
//
// Elements and patterns as in spu_intrinsics.h. Everything is a function, also what the SDK defined as a
// macro.
#ifndef SPU_EMU_VMX2SPU_H
#define SPU_EMU_VMX2SPU_H

#ifndef __cplusplus
#error "vmx2spu.h is for C++ on this engine: name the source .cpp, or run it as real SPU code"
#endif

#include "spu_intrinsics.h"

#include "spu_emu/intrinsics/vmx_arithmetic.h"
#include "spu_emu/intrinsics/vmx_compare.h"
#include "spu_emu/intrinsics/vmx_float.h"
#include "spu_emu/intrinsics/vmx_logical.h"
#include "spu_emu/intrinsics/vmx_memory.h"
#include "spu_emu/intrinsics/vmx_multiply.h"
#include "spu_emu/intrinsics/vmx_pack.h"
#include "spu_emu/intrinsics/vmx_scalar.h"
#include "spu_emu/intrinsics/vmx_shift.h"

#endif
