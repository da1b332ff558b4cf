// Channels, DMA, stops and tags for C sources, whose lines come along.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

extern "C" {

unsigned int spu_emu_c_read_channel(unsigned int channel, const char* file, int line) {
  return spu_readch(channel, file, line);
}

unsigned int spu_emu_c_channel_count(unsigned int channel, const char* file, int line) {
  return spu_readchcnt(channel, file, line);
}

void spu_emu_c_write_channel(unsigned int channel, unsigned int value, const char* file, int line) {
  spu_writech(channel, value, file, line);
}

void spu_emu_c_dma(volatile void* ls, unsigned int ea_high, unsigned int ea_low, unsigned int size,
                   unsigned int tag, unsigned int command, const char* file, int line) {
  spu_mfcdma64(ls, ea_high, ea_low, size, tag, command, file, line);
}

void spu_emu_c_stop(unsigned int code, const char* file, int line) {
  spu_stop(code, file, line);
}

void spu_emu_c_halt(const char* file, int line) {
  spu_emu_halt(file, line);
}

vec_uint4 spu_emu_c_read_fpscr() {
  return spu_mffpscr();
}

void spu_emu_c_write_fpscr(vec_uint4 value) {
  spu_mtfpscr(value);
}

unsigned int spu_emu_c_reserve_tags(unsigned int count) {
  return __mfc_multi_tag_reserve(count);
}

unsigned int spu_emu_c_release_tags(unsigned int tag, unsigned int count) {
  return __mfc_multi_tag_release(tag, count);
}

}  // extern "C"
