// si_ bitwise logic, byte sums, bit counts, sign extension, masks, select and shuffle on qwords.
#ifndef SPU_EMU_INTRINSICS_SPECIFIC_BYTES_H
#define SPU_EMU_INTRINSICS_SPECIFIC_BYTES_H

#include "spu_emu/intrinsics/arithmetic.h"
#include "spu_emu/intrinsics/bits.h"
#include "spu_emu/intrinsics/convert.h"
#include "spu_emu/intrinsics/logical.h"
#include "spu_emu/intrinsics/quadword.h"
#include "spu_emu/intrinsics/specific_lanes.h"

SPU_EMU_INLINE qword si_and(qword a, qword b) {
  return (qword)spu_and((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_andc(qword a, qword b) {
  return (qword)spu_andc((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_or(qword a, qword b) {
  return (qword)spu_or((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_orc(qword a, qword b) {
  return (qword)spu_orc((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_xor(qword a, qword b) {
  return (qword)spu_xor((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_nand(qword a, qword b) {
  return (qword)spu_nand((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_nor(qword a, qword b) {
  return (qword)spu_nor((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_eqv(qword a, qword b) {
  return (qword)spu_eqv((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_andbi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_and(d::any_order<vec_uchar16>(a), d::immediate<vec_uchar16>(value)));
}

SPU_EMU_INLINE qword si_andhi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_and(d::any_order<vec_ushort8>(a), d::immediate<vec_ushort8>(value)));
}

SPU_EMU_INLINE qword si_andi(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)spu_and((vec_uint4)a, d::immediate<vec_uint4>(value));
}

SPU_EMU_INLINE qword si_orbi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_or(d::any_order<vec_uchar16>(a), d::immediate<vec_uchar16>(value)));
}

SPU_EMU_INLINE qword si_orhi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_or(d::any_order<vec_ushort8>(a), d::immediate<vec_ushort8>(value)));
}

SPU_EMU_INLINE qword si_ori(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)spu_or((vec_uint4)a, d::immediate<vec_uint4>(value));
}

SPU_EMU_INLINE qword si_xorbi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_xor(d::any_order<vec_uchar16>(a), d::immediate<vec_uchar16>(value)));
}

SPU_EMU_INLINE qword si_xorhi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_xor(d::any_order<vec_ushort8>(a), d::immediate<vec_ushort8>(value)));
}

SPU_EMU_INLINE qword si_xori(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)spu_xor((vec_uint4)a, d::immediate<vec_uint4>(value));
}

SPU_EMU_INLINE qword si_orx(qword a) {
  return (qword)spu_orx((vec_uint4)a);
}

SPU_EMU_INLINE qword si_selb(qword a, qword b, qword mask) {
  return (qword)spu_sel((vec_uint4)a, (vec_uint4)b, (vec_uint4)mask);
}

// The pattern is a register, too: its bytes count from the left, so a literal comes as
// (qword)(vec_uchar16)...
SPU_EMU_INLINE qword si_shufb(qword a, qword b, qword pattern) {
  const __m128i order = (__m128i)(vec_uint4)pattern;
  return (qword)(vec_uint4)spu_emu::detail::shuffle_bytes((__m128i)(vec_uint4)a, (__m128i)(vec_uint4)b, order,
                                                          3);
}

SPU_EMU_INLINE qword si_clz(qword a) {
  return (qword)spu_cntlz((vec_uint4)a);
}

SPU_EMU_INLINE qword si_cntb(qword a) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cntb(d::any_order<vec_uchar16>(a)));
}

SPU_EMU_INLINE qword si_avgb(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_avg(d::any_order<vec_uchar16>(a), d::any_order<vec_uchar16>(b)));
}

SPU_EMU_INLINE qword si_absdb(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_absd(d::any_order<vec_uchar16>(a), d::any_order<vec_uchar16>(b)));
}

SPU_EMU_INLINE qword si_sumb(qword a, qword b) {
  return (qword)spu_sumb((vec_uchar16)a, (vec_uchar16)b);
}

SPU_EMU_INLINE qword si_xsbh(qword a) {
  namespace d = spu_emu::detail;
  return d::of_any_order((vec_short8)((d::any_order<vec_ushort8>(a) << 8)) >> 8);
}

SPU_EMU_INLINE qword si_xshw(qword a) {
  return (qword)((vec_int4)((vec_uint4)a << 16) >> 16);
}

SPU_EMU_INLINE qword si_xswd(qword a) {
  return (qword)spu_extend((vec_int4)a);
}

SPU_EMU_INLINE qword si_gb(qword a) {
  return (qword)spu_gather((vec_uint4)a);
}

SPU_EMU_INLINE qword si_gbh(qword a) {
  return (qword)spu_gather((vec_ushort8)a);
}

SPU_EMU_INLINE qword si_gbb(qword a) {
  return (qword)spu_gather((vec_uchar16)a);
}

SPU_EMU_INLINE qword si_fsm(qword a) {
  return (qword)spu_maskw(((vec_uint4)a)[0]);
}

SPU_EMU_INLINE qword si_fsmh(qword a) {
  return (qword)spu_maskh(((vec_uint4)a)[0]);
}

SPU_EMU_INLINE qword si_fsmb(qword a) {
  return (qword)spu_maskb(((vec_uint4)a)[0]);
}

SPU_EMU_INLINE qword si_fsmbi(int mask) {
  return (qword)spu_maskb(static_cast<unsigned int>(mask));
}

#endif
