// The SDK's vector type names, as 16-byte vectors of the GNU extension, and the `vector` keyword.
//
// Elements keep the SPU's order: element 0 is the leftmost, the preferred slot. What a little-endian host
// cannot keep is the order of the bytes inside an element. Sources that add_spu_program compiles are
// translated first (SPU_EMU_TRANSLATED): a cast that changes the element width,
// `(vec_ushort8)some_vec_uint4`, reorders bytes there and so gives the SPU's answer, and `vector` is a
// keyword before a built-in type only. What goes through memory, a union or a pointer to another type, still
// sees the host's order.
//
// In other sources such a cast yields the parts of each element swapped; cast through qword there
// (`(vec_ushort8)(qword)v`, see spu_intrinsics.h). `vector` is a macro in them and collides with std::vector:
// define SPU_EMU_NO_VECTOR_KEYWORD before the first SDK header, or `#undef vector` after it; `__vector` and
// the vec_ names stay. They write vec_bint4 for `vector bool int`. Casts that keep the width (float4 <->
// uint4 <-> int4, ushort8 <-> short8, ...) are exact everywhere.
#ifndef SPU_EMU_VEC_TYPES_H
#define SPU_EMU_VEC_TYPES_H

#define SPU_EMU_VECTOR __attribute__((vector_size(16)))
#ifndef SPU_EMU_TRANSLATED
#define __vector SPU_EMU_VECTOR
#ifndef SPU_EMU_NO_VECTOR_KEYWORD
#define vector __vector
#endif
#endif

typedef SPU_EMU_VECTOR unsigned char vec_uchar16;
typedef SPU_EMU_VECTOR signed char vec_char16;
typedef SPU_EMU_VECTOR unsigned short vec_ushort8;
typedef SPU_EMU_VECTOR signed short vec_short8;
typedef SPU_EMU_VECTOR unsigned int vec_uint4;
typedef SPU_EMU_VECTOR signed int vec_int4;
typedef SPU_EMU_VECTOR unsigned long long vec_ullong2;
typedef SPU_EMU_VECTOR signed long long vec_llong2;
typedef SPU_EMU_VECTOR float vec_float4;
typedef SPU_EMU_VECTOR double vec_double2;

// Names of the PPU's vector types, for code that vmx2spu.h carries over.
typedef vec_uchar16 vec_bchar16;
typedef vec_ushort8 vec_bshort8;
typedef vec_ushort8 vec_pixel8;
typedef vec_uint4 vec_bint4;

#ifdef SPU_EMU_TRANSLATED
#ifdef __cplusplus
#include "spu_emu/intrinsics/cast.h"
#endif
#endif

#endif
