// si_ integer compares, giving all ones or zero per lane; clgt names compare unsigned lanes.
#ifndef SPU_EMU_INTRINSICS_SPECIFIC_COMPARE_H
#define SPU_EMU_INTRINSICS_SPECIFIC_COMPARE_H

#include "spu_emu/intrinsics/compare.h"
#include "spu_emu/intrinsics/specific_lanes.h"

SPU_EMU_INLINE qword si_ceqb(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpeq(d::any_order<vec_char16>(a), d::any_order<vec_char16>(b)));
}

SPU_EMU_INLINE qword si_ceqbi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpeq(d::any_order<vec_char16>(a), d::immediate<vec_char16>(value)));
}

SPU_EMU_INLINE qword si_ceqh(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpeq(d::any_order<vec_short8>(a), d::any_order<vec_short8>(b)));
}

SPU_EMU_INLINE qword si_ceqhi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpeq(d::any_order<vec_short8>(a), d::immediate<vec_short8>(value)));
}

SPU_EMU_INLINE qword si_ceq(qword a, qword b) {
  return (qword)spu_cmpeq((vec_int4)a, (vec_int4)b);
}

SPU_EMU_INLINE qword si_ceqi(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)spu_cmpeq((vec_int4)a, d::immediate<vec_int4>(value));
}

SPU_EMU_INLINE qword si_cgtb(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpgt(d::any_order<vec_char16>(a), d::any_order<vec_char16>(b)));
}

SPU_EMU_INLINE qword si_cgtbi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpgt(d::any_order<vec_char16>(a), d::immediate<vec_char16>(value)));
}

SPU_EMU_INLINE qword si_cgth(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpgt(d::any_order<vec_short8>(a), d::any_order<vec_short8>(b)));
}

SPU_EMU_INLINE qword si_cgthi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpgt(d::any_order<vec_short8>(a), d::immediate<vec_short8>(value)));
}

SPU_EMU_INLINE qword si_cgt(qword a, qword b) {
  return (qword)spu_cmpgt((vec_int4)a, (vec_int4)b);
}

SPU_EMU_INLINE qword si_cgti(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)spu_cmpgt((vec_int4)a, d::immediate<vec_int4>(value));
}

SPU_EMU_INLINE qword si_clgtb(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpgt(d::any_order<vec_uchar16>(a), d::any_order<vec_uchar16>(b)));
}

SPU_EMU_INLINE qword si_clgtbi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpgt(d::any_order<vec_uchar16>(a), d::immediate<vec_uchar16>(value)));
}

SPU_EMU_INLINE qword si_clgth(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpgt(d::any_order<vec_ushort8>(a), d::any_order<vec_ushort8>(b)));
}

SPU_EMU_INLINE qword si_clgthi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_cmpgt(d::any_order<vec_ushort8>(a), d::immediate<vec_ushort8>(value)));
}

SPU_EMU_INLINE qword si_clgt(qword a, qword b) {
  return (qword)spu_cmpgt((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_clgti(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)spu_cmpgt((vec_uint4)a, d::immediate<vec_uint4>(value));
}

#endif
