// Channels, DMA, stops and the processor's state in C. What may fault gets the source's line.
#ifndef SPU_EMU_C_CONTROL_H
#define SPU_EMU_C_CONTROL_H

#define spu_readch(channel) spu_emu_c_read_channel(channel, __FILE__, __LINE__)
#define spu_readchcnt(channel) spu_emu_c_channel_count(channel, __FILE__, __LINE__)
#define spu_writech(channel, value) spu_emu_c_write_channel(channel, value, __FILE__, __LINE__)
#define spu_readchqw(channel) ((vec_uint4){spu_readch(channel), 0, 0, 0})
#define spu_writechqw(channel, value) spu_writech(channel, (value)[0])
#define spu_mfcdma64(ls, high, low, size, tag, command) \
  spu_emu_c_dma(ls, high, low, size, tag, command, __FILE__, __LINE__)
#define spu_mfcdma32(ls, ea, size, tag, command) spu_mfcdma64(ls, 0, ea, size, tag, command)
#define spu_mfcstat(type) (spu_writech(23, type), spu_readch(24))
#define spu_stop(code) spu_emu_c_stop(code, __FILE__, __LINE__)
#define spu_stopd(a, b, c) spu_stop(0x3fff)

#define SPU_EMU_HALT_IF(condition) ((condition) ? spu_emu_c_halt(__FILE__, __LINE__) : (void)0)
#define spu_hcmpeq(a, b) SPU_EMU_HALT_IF((a) == (b))
#define spu_hcmpgt(a, b) SPU_EMU_HALT_IF((a) > (b))

#define spu_sync() __sync_synchronize()
#define spu_sync_c() __sync_synchronize()
#define spu_dsync() __sync_synchronize()
// SPU interrupts have no counterpart on the host engine.
#define spu_ienable() ((void)0)
#define spu_idisable() ((void)0)
#define spu_align_hint(pointer, base, offset) ((void)(pointer))
#define spu_mffpscr() spu_emu_c_read_fpscr()
#define spu_mtfpscr(value) spu_emu_c_write_fpscr(value)
#define spu_mfspr(number) 0U
#define spu_mtspr(number, value) ((void)(value))

#define si_rdch(channel) spu_emu_cast_qword(spu_readchqw(channel))
#define si_rchcnt(channel) spu_emu_cast_qword((vec_uint4){spu_readchcnt(channel), 0, 0, 0})
#define si_wrch(channel, value) spu_writechqw(channel, spu_emu_vec_uint4_of_qword(value))
#define si_stop(code) spu_stop(code)
#define si_stopd(a, b, c) spu_stop(0x3fff)
#define si_heq(a, b) spu_hcmpeq(spu_emu_vec_int4_of_qword(a)[0], spu_emu_vec_int4_of_qword(b)[0])
#define si_heqi(a, b) spu_hcmpeq(spu_emu_vec_int4_of_qword(a)[0], b)
#define si_hgt(a, b) spu_hcmpgt(spu_emu_vec_int4_of_qword(a)[0], spu_emu_vec_int4_of_qword(b)[0])
#define si_hgti(a, b) spu_hcmpgt(spu_emu_vec_int4_of_qword(a)[0], b)
#define si_hlgt(a, b) spu_hcmpgt(spu_emu_vec_uint4_of_qword(a)[0], spu_emu_vec_uint4_of_qword(b)[0])
#define si_hlgti(a, b) spu_hcmpgt(spu_emu_vec_uint4_of_qword(a)[0], (unsigned int)(b))
#define si_lnop() ((void)0)
#define si_nop() ((void)0)
#define si_sync() spu_sync()
#define si_syncc() spu_sync()
#define si_dsync() spu_sync()

#endif
