// si_ floating point on qwords: arithmetic, estimates, conversions and compares, single and double.
#ifndef SPU_EMU_INTRINSICS_SPECIFIC_FLOAT_H
#define SPU_EMU_INTRINSICS_SPECIFIC_FLOAT_H

#include "spu_emu/intrinsics/convert.h"
#include "spu_emu/intrinsics/double.h"
#include "spu_emu/intrinsics/estimate.h"
#include "spu_emu/intrinsics/float.h"
#include "spu_emu/intrinsics/float_compare.h"
#include "spu_emu/intrinsics/specific_lanes.h"

SPU_EMU_INLINE qword si_fa(qword a, qword b) {
  return (qword)spu_add((vec_float4)a, (vec_float4)b);
}

SPU_EMU_INLINE qword si_fs(qword a, qword b) {
  return (qword)spu_sub((vec_float4)a, (vec_float4)b);
}

SPU_EMU_INLINE qword si_fm(qword a, qword b) {
  return (qword)spu_mul((vec_float4)a, (vec_float4)b);
}

SPU_EMU_INLINE qword si_fceq(qword a, qword b) {
  return (qword)spu_cmpeq((vec_float4)a, (vec_float4)b);
}

SPU_EMU_INLINE qword si_fcmeq(qword a, qword b) {
  return (qword)spu_cmpabseq((vec_float4)a, (vec_float4)b);
}

SPU_EMU_INLINE qword si_fcgt(qword a, qword b) {
  return (qword)spu_cmpgt((vec_float4)a, (vec_float4)b);
}

SPU_EMU_INLINE qword si_fcmgt(qword a, qword b) {
  return (qword)spu_cmpabsgt((vec_float4)a, (vec_float4)b);
}

SPU_EMU_INLINE qword si_fma(qword a, qword b, qword c) {
  return (qword)spu_madd((vec_float4)a, (vec_float4)b, (vec_float4)c);
}

SPU_EMU_INLINE qword si_fms(qword a, qword b, qword c) {
  return (qword)spu_msub((vec_float4)a, (vec_float4)b, (vec_float4)c);
}

SPU_EMU_INLINE qword si_fnms(qword a, qword b, qword c) {
  return (qword)spu_nmsub((vec_float4)a, (vec_float4)b, (vec_float4)c);
}

SPU_EMU_INLINE qword si_dfa(qword a, qword b) {
  return (qword)spu_add((vec_double2)a, (vec_double2)b);
}

SPU_EMU_INLINE qword si_dfs(qword a, qword b) {
  return (qword)spu_sub((vec_double2)a, (vec_double2)b);
}

SPU_EMU_INLINE qword si_dfm(qword a, qword b) {
  return (qword)spu_mul((vec_double2)a, (vec_double2)b);
}

SPU_EMU_INLINE qword si_dfceq(qword a, qword b) {
  return (qword)spu_cmpeq((vec_double2)a, (vec_double2)b);
}

SPU_EMU_INLINE qword si_dfcmeq(qword a, qword b) {
  return (qword)spu_cmpabseq((vec_double2)a, (vec_double2)b);
}

SPU_EMU_INLINE qword si_dfcgt(qword a, qword b) {
  return (qword)spu_cmpgt((vec_double2)a, (vec_double2)b);
}

SPU_EMU_INLINE qword si_dfcmgt(qword a, qword b) {
  return (qword)spu_cmpabsgt((vec_double2)a, (vec_double2)b);
}

SPU_EMU_INLINE qword si_dfma(qword a, qword b, qword c) {
  return (qword)spu_madd((vec_double2)a, (vec_double2)b, (vec_double2)c);
}

SPU_EMU_INLINE qword si_dfms(qword a, qword b, qword c) {
  return (qword)spu_msub((vec_double2)a, (vec_double2)b, (vec_double2)c);
}

SPU_EMU_INLINE qword si_dfnms(qword a, qword b, qword c) {
  return (qword)spu_nmsub((vec_double2)a, (vec_double2)b, (vec_double2)c);
}

SPU_EMU_INLINE qword si_dfnma(qword a, qword b, qword c) {
  return (qword)spu_nmadd((vec_double2)a, (vec_double2)b, (vec_double2)c);
}

SPU_EMU_INLINE qword si_dftsv(qword a, int kinds) {
  return (qword)spu_testsv((vec_double2)a, kinds);
}

SPU_EMU_INLINE qword si_frest(qword a) {
  return (qword)spu_frest((vec_float4)a);
}

SPU_EMU_INLINE qword si_frsqest(qword a) {
  return (qword)spu_frsqest((vec_float4)a);
}

// Evaluates at a the line b that si_frest or si_frsqest of a gave.
SPU_EMU_INLINE qword si_fi(qword a, qword b) {
  return (qword)spu_emu::detail::interpolate((vec_float4)a, (vec_float4)b);
}

SPU_EMU_INLINE qword si_csflt(qword a, int scale) {
  return (qword)spu_convtf((vec_int4)a, static_cast<unsigned int>(scale));
}

SPU_EMU_INLINE qword si_cuflt(qword a, int scale) {
  return (qword)spu_convtf((vec_uint4)a, static_cast<unsigned int>(scale));
}

SPU_EMU_INLINE qword si_cflts(qword a, int scale) {
  return (qword)spu_convts((vec_float4)a, scale);
}

SPU_EMU_INLINE qword si_cfltu(qword a, int scale) {
  return (qword)spu_convtu((vec_float4)a, scale);
}

SPU_EMU_INLINE qword si_frds(qword a) {
  return (qword)spu_roundtf((vec_double2)a);
}

SPU_EMU_INLINE qword si_fesd(qword a) {
  return (qword)spu_extend((vec_float4)a);
}

#endif
