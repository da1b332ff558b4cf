// si_ functions that steer the processor: halts, stops, channels, the FPSCR, special registers,
// synchronisation.
#ifndef SPU_EMU_INTRINSICS_SPECIFIC_CONTROL_H
#define SPU_EMU_INTRINSICS_SPECIFIC_CONTROL_H

#include "spu_emu/channels.h"
#include "spu_emu/intrinsics/control.h"
#include "spu_emu/intrinsics/specific_lanes.h"

// Halts compare preferred words; immediates are sign-extended. si_hlgt and si_hlgti compare unsigned words.
SPU_EMU_INLINE void si_heq(qword a, qword b, const char* file = __builtin_FILE(),
                           int line = __builtin_LINE()) {
  spu_hcmpeq(((vec_int4)a)[0], ((vec_int4)b)[0], file, line);
}

SPU_EMU_INLINE void si_heqi(qword a, int value, const char* file = __builtin_FILE(),
                            int line = __builtin_LINE()) {
  spu_hcmpeq(((vec_int4)a)[0], static_cast<int>(value), file, line);
}

SPU_EMU_INLINE void si_hgt(qword a, qword b, const char* file = __builtin_FILE(),
                           int line = __builtin_LINE()) {
  spu_hcmpgt(((vec_int4)a)[0], ((vec_int4)b)[0], file, line);
}

SPU_EMU_INLINE void si_hgti(qword a, int value, const char* file = __builtin_FILE(),
                            int line = __builtin_LINE()) {
  spu_hcmpgt(((vec_int4)a)[0], static_cast<int>(value), file, line);
}

SPU_EMU_INLINE void si_hlgt(qword a, qword b, const char* file = __builtin_FILE(),
                            int line = __builtin_LINE()) {
  spu_hcmpgt(((vec_uint4)a)[0], ((vec_uint4)b)[0], file, line);
}

SPU_EMU_INLINE void si_hlgti(qword a, int value, const char* file = __builtin_FILE(),
                             int line = __builtin_LINE()) {
  spu_hcmpgt(((vec_uint4)a)[0], static_cast<unsigned int>(value), file, line);
}

SPU_EMU_INLINE void si_bisled(qword function, void* link) {
  spu_bisled(reinterpret_cast<void*>(((vec_ullong2)(vec_uint4)function)[0]), link);
}

SPU_EMU_INLINE void si_bisledd(qword function, void* link) {
  si_bisled(function, link);
}

SPU_EMU_INLINE void si_bislede(qword function, void* link) {
  si_bisled(function, link);
}

SPU_EMU_INLINE void si_stop(unsigned int code, const char* file = __builtin_FILE(),
                            int line = __builtin_LINE()) {
  spu_stop(code, file, line);
}

SPU_EMU_INLINE void si_stopd(qword, qword, qword, const char* file = __builtin_FILE(),
                             int line = __builtin_LINE()) {
  spu_stopd(file, line);
}

SPU_EMU_INLINE void si_lnop() {}
SPU_EMU_INLINE void si_nop() {}

SPU_EMU_INLINE void si_sync() {
  spu_sync();
}

SPU_EMU_INLINE void si_syncc() {
  spu_sync_c();
}

SPU_EMU_INLINE void si_dsync() {
  spu_dsync();
}

SPU_EMU_INLINE qword si_mfspr(int reg) {
  return (qword)vec_uint4{spu_mfspr(static_cast<unsigned int>(reg)), 0, 0, 0};
}

SPU_EMU_INLINE void si_mtspr(int reg, qword value) {
  spu_mtspr(static_cast<unsigned int>(reg), ((vec_uint4)value)[0]);
}

SPU_EMU_INLINE qword si_fscrrd() {
  return (qword)spu_mffpscr();
}

SPU_EMU_INLINE void si_fscrwr(qword value) {
  spu_mtfpscr((vec_uint4)value);
}

SPU_EMU_INLINE qword si_rdch(unsigned int channel, const char* file = __builtin_FILE(),
                             int line = __builtin_LINE()) {
  return (qword)spu_readchqw(channel, file, line);
}

SPU_EMU_INLINE qword si_rchcnt(unsigned int channel, const char* file = __builtin_FILE(),
                               int line = __builtin_LINE()) {
  return (qword)vec_uint4{spu_readchcnt(channel, file, line), 0, 0, 0};
}

SPU_EMU_INLINE void si_wrch(unsigned int channel, qword value, const char* file = __builtin_FILE(),
                            int line = __builtin_LINE()) {
  spu_writechqw(channel, (vec_uint4)value, file, line);
}

#endif
