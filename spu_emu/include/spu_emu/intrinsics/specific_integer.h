// si_ integer arithmetic, multiplication and constants on qwords.
#ifndef SPU_EMU_INTRINSICS_SPECIFIC_INTEGER_H
#define SPU_EMU_INTRINSICS_SPECIFIC_INTEGER_H

#include "spu_emu/intrinsics/arithmetic.h"
#include "spu_emu/intrinsics/logical.h"
#include "spu_emu/intrinsics/multiply.h"
#include "spu_emu/intrinsics/specific_lanes.h"

SPU_EMU_INLINE qword si_ilh(int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(d::immediate<vec_ushort8>(value));
}

SPU_EMU_INLINE qword si_ilhu(int value) {
  namespace d = spu_emu::detail;
  return (qword)(d::immediate<vec_uint4>(value) << 16);
}

SPU_EMU_INLINE qword si_il(int value) {
  namespace d = spu_emu::detail;
  return (qword)d::immediate<vec_int4>(static_cast<short>(value));
}

SPU_EMU_INLINE qword si_ila(int value) {
  namespace d = spu_emu::detail;
  return (qword)d::immediate<vec_uint4>(value & 0x3ffff);
}

SPU_EMU_INLINE qword si_iohl(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)((vec_uint4)a | d::immediate<vec_uint4>(value & 0xffff));
}

// si_sf and its kin subtract the first operand from the second.

SPU_EMU_INLINE qword si_ah(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_add(d::any_order<vec_ushort8>(a), d::any_order<vec_ushort8>(b)));
}

SPU_EMU_INLINE qword si_ahi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_add(d::any_order<vec_ushort8>(a), d::immediate<vec_ushort8>(value)));
}

SPU_EMU_INLINE qword si_sfh(qword a, qword b) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_sub(d::any_order<vec_ushort8>(b), d::any_order<vec_ushort8>(a)));
}

SPU_EMU_INLINE qword si_sfhi(qword a, int value) {
  namespace d = spu_emu::detail;
  return d::of_any_order(spu_sub(d::immediate<vec_ushort8>(value), d::any_order<vec_ushort8>(a)));
}

SPU_EMU_INLINE qword si_a(qword a, qword b) {
  return (qword)spu_add((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_ai(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)spu_add((vec_uint4)a, d::immediate<vec_uint4>(value));
}

SPU_EMU_INLINE qword si_sf(qword a, qword b) {
  return (qword)spu_sub((vec_uint4)b, (vec_uint4)a);
}

SPU_EMU_INLINE qword si_sfi(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)spu_sub(d::immediate<vec_uint4>(value), (vec_uint4)a);
}

SPU_EMU_INLINE qword si_addx(qword a, qword b, qword c) {
  return (qword)spu_addx((vec_uint4)a, (vec_uint4)b, (vec_uint4)c);
}

SPU_EMU_INLINE qword si_cg(qword a, qword b) {
  return (qword)spu_genc((vec_uint4)a, (vec_uint4)b);
}

SPU_EMU_INLINE qword si_cgx(qword a, qword b, qword c) {
  return (qword)spu_gencx((vec_uint4)a, (vec_uint4)b, (vec_uint4)c);
}

SPU_EMU_INLINE qword si_sfx(qword a, qword b, qword c) {
  return (qword)spu_subx((vec_uint4)b, (vec_uint4)a, (vec_uint4)c);
}

SPU_EMU_INLINE qword si_bg(qword a, qword b) {
  return (qword)spu_genb((vec_uint4)b, (vec_uint4)a);
}

SPU_EMU_INLINE qword si_bgx(qword a, qword b, qword c) {
  return (qword)spu_genbx((vec_uint4)b, (vec_uint4)a, (vec_uint4)c);
}

// Products of right halves; the names with hh take left halves, si_mpyh the left half of a and the right of
// b. Halves of a word in true order, but without the reordering of bytes: left and right are swapped in the
// host's word, so that a right half is the word's low half.
namespace spu_emu::detail {

SPU_EMU_INLINE vec_int4 right_half(qword q) {
  return ((vec_int4)q << 16) >> 16;
}

SPU_EMU_INLINE vec_int4 left_half(qword q) {
  return (vec_int4)q >> 16;
}

SPU_EMU_INLINE vec_uint4 unsigned_right_half(qword q) {
  return (vec_uint4)q & splat<vec_uint4>(0xffff);
}

SPU_EMU_INLINE vec_uint4 unsigned_left_half(qword q) {
  return (vec_uint4)q >> 16;
}

// Unsigned, because a sum with a product may wrap.
SPU_EMU_INLINE vec_uint4 product(vec_int4 a, vec_int4 b) {
  return (vec_uint4)a * (vec_uint4)b;
}

}  // namespace spu_emu::detail

SPU_EMU_INLINE qword si_mpy(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)d::product(d::right_half(a), d::right_half(b));
}

SPU_EMU_INLINE qword si_mpyu(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)(d::unsigned_right_half(a) * d::unsigned_right_half(b));
}

SPU_EMU_INLINE qword si_mpyi(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)d::product(d::right_half(a), d::immediate<vec_int4>(static_cast<short>(value)));
}

SPU_EMU_INLINE qword si_mpyui(qword a, int value) {
  namespace d = spu_emu::detail;
  return (qword)(d::unsigned_right_half(a) * d::immediate<vec_uint4>(value & 0xffff));
}

SPU_EMU_INLINE qword si_mpya(qword a, qword b, qword c) {
  namespace d = spu_emu::detail;
  return (qword)(d::product(d::right_half(a), d::right_half(b)) + (vec_uint4)c);
}

SPU_EMU_INLINE qword si_mpyh(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)(d::product(d::left_half(a), d::right_half(b)) << 16);
}

SPU_EMU_INLINE qword si_mpys(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)((vec_int4)d::product(d::right_half(a), d::right_half(b)) >> 16);
}

SPU_EMU_INLINE qword si_mpyhh(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)d::product(d::left_half(a), d::left_half(b));
}

SPU_EMU_INLINE qword si_mpyhhu(qword a, qword b) {
  namespace d = spu_emu::detail;
  return (qword)(d::unsigned_left_half(a) * d::unsigned_left_half(b));
}

SPU_EMU_INLINE qword si_mpyhha(qword a, qword b, qword c) {
  namespace d = spu_emu::detail;
  return (qword)(d::product(d::left_half(a), d::left_half(b)) + (vec_uint4)c);
}

SPU_EMU_INLINE qword si_mpyhhau(qword a, qword b, qword c) {
  namespace d = spu_emu::detail;
  return (qword)(d::unsigned_left_half(a) * d::unsigned_left_half(b) + (vec_uint4)c);
}

#endif
