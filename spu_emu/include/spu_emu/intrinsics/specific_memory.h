// si_ loads and stores of quadwords, and the patterns that insert a scalar into one.
//
// An address is a qword made by si_from_ptr, or one whose word 0 was changed by arithmetic: word 0 is the
// local-store address and word 1 the high half of host pointers into the same local store. Loads and stores
// ignore the low four address bits and move four host words; data of another width needs a cast through
// qword. The absolute and PC-relative forms (si_lqa, si_lqr, si_stqa, si_stqr) are missing: their operands
// are addresses in an SPU's program image, which a host program does not have.
#ifndef SPU_EMU_INTRINSICS_SPECIFIC_MEMORY_H
#define SPU_EMU_INTRINSICS_SPECIFIC_MEMORY_H

#include "spu_emu/intrinsics/specific_lanes.h"

namespace spu_emu::detail {

SPU_EMU_INLINE __m128i* quadword_at(unsigned int low, unsigned int high) {
  return reinterpret_cast<__m128i*>((low & ~15U) | (static_cast<std::uint64_t>(high) << 32));
}

SPU_EMU_INLINE __m128i* displaced(qword base, int displacement) {
  const vec_uint4 words = (vec_uint4)base;
  return quadword_at(words[0] + static_cast<unsigned int>(displacement), words[1]);
}

// Either operand may be the pointer and the other the offset, whose word 1 is then 0, or may repeat word 0.
SPU_EMU_INLINE __m128i* indexed(qword a, qword b) {
  const vec_uint4 x = (vec_uint4)a;
  const vec_uint4 y = (vec_uint4)b;
  const bool a_is_offset = x[1] == x[0] || x[1] == 0;
  return quadword_at(x[0] + y[0], a_is_offset ? y[1] : x[1]);
}

// The identity on the second operand of si_shufb but for `width` bytes at the address's offset, which come
// from the first operand's preferred slot.
SPU_EMU_INLINE qword insertion_pattern(unsigned int address, unsigned int width) {
  vec_uchar16 pattern = {16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
  const unsigned int at = address & 15U & ~(width - 1);
  const unsigned int preferred_byte = width < 4 ? 4 - width : 0;
  for (unsigned int k = 0; k < width; ++k) pattern[at + k] = static_cast<unsigned char>(preferred_byte + k);
  return (qword)pattern;
}

}  // namespace spu_emu::detail

// Displacements are in bytes.
SPU_EMU_INLINE qword si_lqd(qword base, int displacement) {
  return (qword)(vec_uint4)_mm_load_si128(spu_emu::detail::displaced(base, displacement));
}

SPU_EMU_INLINE qword si_lqx(qword a, qword b) {
  return (qword)(vec_uint4)_mm_load_si128(spu_emu::detail::indexed(a, b));
}

SPU_EMU_INLINE void si_stqd(qword value, qword base, int displacement) {
  _mm_store_si128(spu_emu::detail::displaced(base, displacement), (__m128i)(vec_uint4)value);
}

SPU_EMU_INLINE void si_stqx(qword value, qword a, qword b) {
  _mm_store_si128(spu_emu::detail::indexed(a, b), (__m128i)(vec_uint4)value);
}

SPU_EMU_INLINE qword si_cbd(qword base, int displacement) {
  return spu_emu::detail::insertion_pattern(((vec_uint4)base)[0] + static_cast<unsigned int>(displacement),
                                            1);
}

SPU_EMU_INLINE qword si_cbx(qword a, qword b) {
  return spu_emu::detail::insertion_pattern(((vec_uint4)a)[0] + ((vec_uint4)b)[0], 1);
}

SPU_EMU_INLINE qword si_chd(qword base, int displacement) {
  return spu_emu::detail::insertion_pattern(((vec_uint4)base)[0] + static_cast<unsigned int>(displacement),
                                            2);
}

SPU_EMU_INLINE qword si_chx(qword a, qword b) {
  return spu_emu::detail::insertion_pattern(((vec_uint4)a)[0] + ((vec_uint4)b)[0], 2);
}

SPU_EMU_INLINE qword si_cwd(qword base, int displacement) {
  return spu_emu::detail::insertion_pattern(((vec_uint4)base)[0] + static_cast<unsigned int>(displacement),
                                            4);
}

SPU_EMU_INLINE qword si_cwx(qword a, qword b) {
  return spu_emu::detail::insertion_pattern(((vec_uint4)a)[0] + ((vec_uint4)b)[0], 4);
}

SPU_EMU_INLINE qword si_cdd(qword base, int displacement) {
  return spu_emu::detail::insertion_pattern(((vec_uint4)base)[0] + static_cast<unsigned int>(displacement),
                                            8);
}

SPU_EMU_INLINE qword si_cdx(qword a, qword b) {
  return spu_emu::detail::insertion_pattern(((vec_uint4)a)[0] + ((vec_uint4)b)[0], 8);
}

#endif
