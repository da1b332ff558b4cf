// The channel, DMA and control intrinsics of spu_intrinsics.h: each one a call of the emulation.
//
// Every function takes the caller's file and line as defaulted arguments, so that a fault names SPU source.
#ifndef SPU_EMU_CHANNELS_H
#define SPU_EMU_CHANNELS_H

#include <vec_types.h>

#include "spu_emu/channel_numbers.h"
#include "spu_emu/services.h"
#include "spu_emu/special_values.h"

inline unsigned int spu_readch(unsigned int channel, const char* file = __builtin_FILE(),
                               int line = __builtin_LINE()) {
  return spu_emu_services->read_channel(spu_emu_services->spe, channel, {file, line});
}

inline void spu_writech(unsigned int channel, unsigned int value, const char* file = __builtin_FILE(),
                        int line = __builtin_LINE()) {
  spu_emu_services->write_channel(spu_emu_services->spe, channel, value, {file, line});
}

inline unsigned int spu_readchcnt(unsigned int channel, const char* file = __builtin_FILE(),
                                  int line = __builtin_LINE()) {
  return spu_emu_services->channel_count(spu_emu_services->spe, channel, {file, line});
}

/// The channel's word in the preferred slot; no channel of the Cell carries more than a word.
inline vec_uint4 spu_readchqw(unsigned int channel, const char* file = __builtin_FILE(),
                              int line = __builtin_LINE()) {
  const unsigned int word = spu_readch(channel, file, line);
  return vec_uint4{word, 0, 0, 0};
}

/// Writes the preferred slot of `value`.
inline void spu_writechqw(unsigned int channel, vec_uint4 value, const char* file = __builtin_FILE(),
                          int line = __builtin_LINE()) {
  spu_writech(channel, value[0], file, line);
}

inline void spu_mfcdma64(volatile void* ls, unsigned int ea_high, unsigned int ea_low, unsigned int size,
                         unsigned int tag, unsigned int command, const char* file = __builtin_FILE(),
                         int line = __builtin_LINE()) {
  const unsigned long long ea = (static_cast<unsigned long long>(ea_high) << 32) | ea_low;
  spu_emu_services->dma(spu_emu_services->spe, ls, ea, size, tag, command, file, line);
}

inline void spu_mfcdma32(volatile void* ls, unsigned int ea, unsigned int size, unsigned int tag,
                         unsigned int command, const char* file = __builtin_FILE(),
                         int line = __builtin_LINE()) {
  spu_mfcdma64(ls, 0, ea, size, tag, command, file, line);
}

/// Asks for the tag status (0 immediate, 1 any, 2 all of the tag mask) and reads it.
inline unsigned int spu_mfcstat(unsigned int type, const char* file = __builtin_FILE(),
                                int line = __builtin_LINE()) {
  spu_writech(MFC_WrTagUpdate, type, file, line);
  return spu_readch(MFC_RdTagStat, file, line);
}

/// Stop and signal; the program goes on here when its context is run again.
inline void spu_stop(unsigned int code, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  spu_emu_services->stop(spu_emu_services->spe, code & 0x3fffU, {file, line});
}

/// Stop with dependencies: the same stop with the code that the instruction carries, 0x3fff.
inline void spu_stopd(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  spu_stop(0x3fffU, file, line);
}

/// What the halt-if instructions do when their condition holds; the program cannot be resumed.
inline void spu_emu_halt(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  spu_emu_services->halt(spu_emu_services->spe, {file, line});
}

inline void spu_sync() {
  __sync_synchronize();
}
inline void spu_sync_c() {
  __sync_synchronize();
}
inline void spu_dsync() {
  __sync_synchronize();
}

/// SPU interrupts have no counterpart on the host engine: events are polled, so both do nothing.
inline void spu_idisable() {}
inline void spu_ienable() {}

#endif
