// Scalars in and out of a qword's preferred slot: si_from_ and si_to_ functions.
//
// The preferred slot is byte 3, halfword 1, word 0 or doubleword 0, counted from the left. Every si_from_
// function repeats its scalar in all lanes of its width but si_from_ptr, which puts a host pointer's low
// half, the local-store address, into word 0 and its high half into word 1.
#ifndef SPU_EMU_INTRINSICS_SPECIFIC_SCALAR_H
#define SPU_EMU_INTRINSICS_SPECIFIC_SCALAR_H

#include "spu_emu/intrinsics/specific_lanes.h"

SPU_EMU_INLINE qword si_from_char(signed char scalar) {
  return (qword)spu_splats(scalar);
}

SPU_EMU_INLINE signed char si_to_char(qword a) {
  return ((vec_char16)a)[3];
}

SPU_EMU_INLINE qword si_from_uchar(unsigned char scalar) {
  return (qword)spu_splats(scalar);
}

SPU_EMU_INLINE unsigned char si_to_uchar(qword a) {
  return ((vec_uchar16)a)[3];
}

SPU_EMU_INLINE qword si_from_short(short scalar) {
  return (qword)spu_splats(scalar);
}

SPU_EMU_INLINE short si_to_short(qword a) {
  return ((vec_short8)a)[1];
}

SPU_EMU_INLINE qword si_from_ushort(unsigned short scalar) {
  return (qword)spu_splats(scalar);
}

SPU_EMU_INLINE unsigned short si_to_ushort(qword a) {
  return ((vec_ushort8)a)[1];
}

SPU_EMU_INLINE qword si_from_int(int scalar) {
  return (qword)spu_splats(scalar);
}

SPU_EMU_INLINE int si_to_int(qword a) {
  return ((vec_int4)a)[0];
}

SPU_EMU_INLINE qword si_from_uint(unsigned int scalar) {
  return (qword)spu_splats(scalar);
}

SPU_EMU_INLINE unsigned int si_to_uint(qword a) {
  return ((vec_uint4)a)[0];
}

SPU_EMU_INLINE qword si_from_llong(long long scalar) {
  return (qword)spu_splats(scalar);
}

SPU_EMU_INLINE long long si_to_llong(qword a) {
  return ((vec_llong2)a)[0];
}

SPU_EMU_INLINE qword si_from_ullong(unsigned long long scalar) {
  return (qword)spu_splats(scalar);
}

SPU_EMU_INLINE unsigned long long si_to_ullong(qword a) {
  return ((vec_ullong2)a)[0];
}

SPU_EMU_INLINE qword si_from_float(float scalar) {
  return (qword)spu_splats(scalar);
}

SPU_EMU_INLINE float si_to_float(qword a) {
  return ((vec_float4)a)[0];
}

SPU_EMU_INLINE qword si_from_double(double scalar) {
  return (qword)spu_splats(scalar);
}

SPU_EMU_INLINE double si_to_double(qword a) {
  return ((vec_double2)a)[0];
}

SPU_EMU_INLINE qword si_from_ptr(const volatile void* pointer) {
  const std::uint64_t address = reinterpret_cast<std::uintptr_t>(pointer);
  return (qword)vec_uint4{static_cast<unsigned int>(address), static_cast<unsigned int>(address >> 32), 0, 0};
}

SPU_EMU_INLINE void* si_to_ptr(qword a) {
  const vec_uint4 words = (vec_uint4)a;
  return reinterpret_cast<void*>(words[0] | (static_cast<std::uint64_t>(words[1]) << 32));
}

#endif
