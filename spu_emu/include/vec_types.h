// The SDK's vector type names, as 16-byte vectors of the GNU extension, and the `vector` keyword.
//
// Elements keep the SPU's order: element 0 is the leftmost, the preferred slot. What a little-endian host
// cannot keep is the order of the bytes inside an element, so a plain cast that changes the element width,
// `(vec_ushort8)some_vec_uint4`, yields the halves of each word swapped against the SPU. Cast through qword
// (`(vec_ushort8)(qword)v`, see spu_intrinsics.h), which reorders and so gives the SPU's answer.
// Casts that keep the width (float4 <-> uint4 <-> int4, ushort8 <-> short8, ...) are exact as they stand.
//
// `vector float` and `__vector float` compile as SDK sources write them. `vector` is a macro here and
// therefore collides with std::vector: define SPU_EMU_NO_VECTOR_KEYWORD before the first SDK header (or
// `#undef vector` after it) in files that want std::vector; `__vector` and the vec_ names stay. `vector bool`
// has no host form: write vec_bchar16, vec_bshort8 or vec_bint4, which on an SPU are the unsigned vectors,
// too.
#ifndef SPU_EMU_VEC_TYPES_H
#define SPU_EMU_VEC_TYPES_H

#define __vector __attribute__((vector_size(16)))
#ifndef SPU_EMU_NO_VECTOR_KEYWORD
#define vector __vector
#endif

using vec_uchar16 = __vector unsigned char;
using vec_char16 = __vector signed char;
using vec_ushort8 = __vector unsigned short;
using vec_short8 = __vector signed short;
using vec_uint4 = __vector unsigned int;
using vec_int4 = __vector signed int;
using vec_ullong2 = __vector unsigned long long;
using vec_llong2 = __vector signed long long;
using vec_float4 = __vector float;
using vec_double2 = __vector double;

// Names of the PPU's vector types, for code that vmx2spu.h carries over.
using vec_bchar16 = vec_uchar16;
using vec_bshort8 = vec_ushort8;
using vec_pixel8 = vec_ushort8;
using vec_bint4 = vec_uint4;

#endif
