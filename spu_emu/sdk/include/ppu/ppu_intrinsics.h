/* The compiler's ppu_intrinsics.h. In 32 bits no emulated processor has the instructions that a Cell takes
 * from 64-bit PowerPC, and with dcbz they clear 32 bytes at a time: what these intrinsics promise is done by
 * others there. */
#ifndef SPU_EMU_SDK_PPU_INTRINSICS_H
#define SPU_EMU_SDK_PPU_INTRINSICS_H

#if !defined(__powerpc__)
#error "ppu_intrinsics.h is for the PowerPC half of a Cell; a host side that uses it is compiled by ppu-gcc"
#endif

#include_next <ppu_intrinsics.h>

#if !defined(__powerpc64__)
#undef __dcbz

/* Of the line of 128 bytes that the address lies in. */
static __inline__ void __dcbz(void* base) {
  char* line = (char*)((unsigned long)base & ~127UL);
  int part;
  for (part = 0; part < 128; part += 32) __asm__ volatile("dcbz 0,%0" : : "r"(line + part) : "memory");
}
static __inline__ double cell_fsqrt(double x) {
  return __builtin_sqrt(x);
}
static __inline__ float cell_fsqrts(float x) {
  return __builtin_sqrtf(x);
}
static __inline__ long long cell_fctid(double x) {
  return __builtin_llrint(x);
}
static __inline__ long long cell_fctidz(double x) {
  return (long long)x;
}
static __inline__ double cell_fcfid(long long x) {
  return (double)x;
}
#define __fsqrt(x) cell_fsqrt(x)
#define __fsqrts(x) cell_fsqrts(x)
#define __fctid(x) cell_fctid(x)
#define __fctidz(x) cell_fctidz(x)
#define __fcfid(x) cell_fcfid(x)
#endif

#endif
