// What the macros of C sources call, beside the vector intrinsics; in runtime/c_services.cpp.
#ifndef SPU_EMU_C_SERVICES_H
#define SPU_EMU_C_SERVICES_H

#include "vec_types.h"

extern unsigned int spu_emu_c_read_channel(unsigned int channel, const char* file, int line);
extern unsigned int spu_emu_c_channel_count(unsigned int channel, const char* file, int line);
extern void spu_emu_c_write_channel(unsigned int channel, unsigned int value, const char* file, int line);
extern void spu_emu_c_dma(volatile void* ls, unsigned int ea_high, unsigned int ea_low, unsigned int size,
                          unsigned int tag, unsigned int command, const char* file, int line);
extern void spu_emu_c_stop(unsigned int code, const char* file, int line);
extern void spu_emu_c_halt(const char* file, int line);
extern vec_uint4 spu_emu_c_read_fpscr(void);
extern void spu_emu_c_write_fpscr(vec_uint4 value);
extern unsigned int spu_emu_c_reserve_tags(unsigned int count);
extern unsigned int spu_emu_c_release_tags(unsigned int tag, unsigned int count);

#endif
