// si_ shifts and rotates of halfwords, words and the whole qword, by registers and by immediates.
//
// The rotm and rotma names shift right by the negated count. Quadword counts come from the preferred slot.
#ifndef SPU_EMU_INTRINSICS_SPECIFIC_SHIFT_H
#define SPU_EMU_INTRINSICS_SPECIFIC_SHIFT_H

#include "spu_emu/intrinsics/quadword.h"
#include "spu_emu/intrinsics/shift.h"
#include "spu_emu/intrinsics/specific_lanes.h"

SPU_EMU_INLINE qword si_shlh(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_sl(d::any_order<vec_ushort8>(a), d::any_order<vec_ushort8>(b)));
}

SPU_EMU_INLINE qword si_shlhi(qword a, int count) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_sl(d::any_order<vec_ushort8>(a), static_cast<unsigned int>(count)));
}

SPU_EMU_INLINE qword si_roth(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_rl(d::any_order<vec_ushort8>(a), d::any_order<vec_short8>(b)));
}

SPU_EMU_INLINE qword si_rothi(qword a, int count) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_rl(d::any_order<vec_ushort8>(a), count));
}

SPU_EMU_INLINE qword si_rothm(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_rlmask(d::any_order<vec_ushort8>(a), d::any_order<vec_short8>(b)));
}

SPU_EMU_INLINE qword si_rothmi(qword a, int count) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_rlmask(d::any_order<vec_ushort8>(a), count));
}

SPU_EMU_INLINE qword si_rotmah(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_rlmaska(d::any_order<vec_ushort8>(a), d::any_order<vec_short8>(b)));
}

SPU_EMU_INLINE qword si_rotmahi(qword a, int count) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_rlmaska(d::any_order<vec_ushort8>(a), count));
}

SPU_EMU_INLINE qword si_shl(qword a, qword b) {
  return (qword)spu_sl((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_shli(qword a, int count) {
  return (qword)spu_sl((vec_uint4)a, static_cast<unsigned int>(count));
}

SPU_EMU_INLINE qword si_rot(qword a, qword b) {
  return (qword)spu_rl((vec_uint4)a, (vec_int4)b);
}

SPU_EMU_INLINE qword si_roti(qword a, int count) {
  return (qword)spu_rl((vec_uint4)a, count);
}

SPU_EMU_INLINE qword si_rotm(qword a, qword b) {
  return (qword)spu_rlmask((vec_uint4)a, (vec_int4)b);
}

SPU_EMU_INLINE qword si_rotmi(qword a, int count) {
  return (qword)spu_rlmask((vec_uint4)a, count);
}

SPU_EMU_INLINE qword si_rotma(qword a, qword b) {
  return (qword)spu_rlmaska((vec_uint4)a, (vec_int4)b);
}

SPU_EMU_INLINE qword si_rotmai(qword a, int count) {
  return (qword)spu_rlmaska((vec_uint4)a, count);
}

SPU_EMU_INLINE qword si_shlqbi(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)spu_slqw((vec_uint4)a, static_cast<unsigned int>(d::preferred(b)));
}

SPU_EMU_INLINE qword si_shlqbii(qword a, int count) {
  return (qword)spu_slqw((vec_uint4)a, static_cast<unsigned int>(count));
}

SPU_EMU_INLINE qword si_shlqby(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)spu_slqwbyte((vec_uint4)a, static_cast<unsigned int>(d::preferred(b)));
}

SPU_EMU_INLINE qword si_shlqbyi(qword a, int count) {
  return (qword)spu_slqwbyte((vec_uint4)a, static_cast<unsigned int>(count));
}

SPU_EMU_INLINE qword si_rotqbi(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)spu_rlqw((vec_uint4)a, d::preferred(b));
}

SPU_EMU_INLINE qword si_rotqbii(qword a, int count) {
  return (qword)spu_rlqw((vec_uint4)a, count);
}

SPU_EMU_INLINE qword si_rotqby(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)spu_rlqwbyte((vec_uint4)a, d::preferred(b));
}

SPU_EMU_INLINE qword si_rotqbyi(qword a, int count) {
  return (qword)spu_rlqwbyte((vec_uint4)a, count);
}

SPU_EMU_INLINE qword si_rotqmbi(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)spu_rlmaskqw((vec_uint4)a, d::preferred(b));
}

SPU_EMU_INLINE qword si_rotqmbii(qword a, int count) {
  return (qword)spu_rlmaskqw((vec_uint4)a, count);
}

SPU_EMU_INLINE qword si_rotqmby(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)spu_rlmaskqwbyte((vec_uint4)a, d::preferred(b));
}

SPU_EMU_INLINE qword si_rotqmbyi(qword a, int count) {
  return (qword)spu_rlmaskqwbyte((vec_uint4)a, count);
}

SPU_EMU_INLINE qword si_shlqbybi(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)spu_slqwbytebc((vec_uint4)a, static_cast<unsigned int>(d::preferred(b)));
}

SPU_EMU_INLINE qword si_rotqbybi(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)spu_rlqwbytebc((vec_uint4)a, d::preferred(b));
}

SPU_EMU_INLINE qword si_rotqmbybi(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)spu_rlmaskqwbytebc((vec_uint4)a, d::preferred(b));
}

#endif
