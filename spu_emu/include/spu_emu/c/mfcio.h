// spu_mfcio.h in C: macros, so that a fault names the line that used them.
#ifndef SPU_EMU_C_MFCIO_H
#define SPU_EMU_C_MFCIO_H

#include <stdint.h>

#include "spu_emu/c/services.h"
#include "spu_emu/mfc_opcodes.h"

// Words with the values of the Cell, as in C++.
typedef struct mfc_list_element_t {
  unsigned int size : 15;
  unsigned int reserved : 16;
  unsigned int notify : 1;
  unsigned int eal;
} mfc_list_element_t;
typedef mfc_list_element_t mfc_list_element;

#define MFC_CMD_WORD(tid, rid, command) (((tid) << 24) | ((rid) << 16) | (command))
#define mfc_ea2h(ea) ((unsigned int)((unsigned long long)(ea) >> 32))
#define mfc_ea2l(ea) ((unsigned int)(unsigned long long)(ea))
#define mfc_hl2ea(high, low) (((unsigned long long)(high) << 32) | (unsigned int)(low))
#define mfc_ceil128(value) (((value) + 127) & ~127)

#define SPU_EMU_C_DMA(ls, high, low, size, tag, tid, rid, command) \
  spu_emu_c_dma(ls, high, low, size, tag, MFC_CMD_WORD(tid, rid, command), __FILE__, __LINE__)
#define SPU_EMU_C_TRANSFER(ls, ea, size, tag, tid, rid, command)                                 \
  __extension__({                                                                                \
    const unsigned long long spu_emu_ea = (ea);                                                  \
    SPU_EMU_C_DMA(ls, mfc_ea2h(spu_emu_ea), mfc_ea2l(spu_emu_ea), size, tag, tid, rid, command); \
  })
// The list is a pointer or an LS address.
#define SPU_EMU_C_LIST(ls, ea, lsa, size, tag, tid, rid, command) \
  SPU_EMU_C_DMA(ls, mfc_ea2h(ea), (unsigned int)(uintptr_t)(lsa), size, tag, tid, rid, command)

#define mfc_put(ls, ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, size, tag, tid, rid, MFC_PUT_CMD)
#define mfc_putf(ls, ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, size, tag, tid, rid, MFC_PUTF_CMD)
#define mfc_putb(ls, ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, size, tag, tid, rid, MFC_PUTB_CMD)
#define mfc_get(ls, ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, size, tag, tid, rid, MFC_GET_CMD)
#define mfc_getf(ls, ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, size, tag, tid, rid, MFC_GETF_CMD)
#define mfc_getb(ls, ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, size, tag, tid, rid, MFC_GETB_CMD)
#define mfc_putl(ls, ea, lsa, size, tag, tid, rid) \
  SPU_EMU_C_LIST(ls, ea, lsa, size, tag, tid, rid, MFC_PUTL_CMD)
#define mfc_putlf(ls, ea, lsa, size, tag, tid, rid) \
  SPU_EMU_C_LIST(ls, ea, lsa, size, tag, tid, rid, MFC_PUTLF_CMD)
#define mfc_putlb(ls, ea, lsa, size, tag, tid, rid) \
  SPU_EMU_C_LIST(ls, ea, lsa, size, tag, tid, rid, MFC_PUTLB_CMD)
#define mfc_getl(ls, ea, lsa, size, tag, tid, rid) \
  SPU_EMU_C_LIST(ls, ea, lsa, size, tag, tid, rid, MFC_GETL_CMD)
#define mfc_getlf(ls, ea, lsa, size, tag, tid, rid) \
  SPU_EMU_C_LIST(ls, ea, lsa, size, tag, tid, rid, MFC_GETLF_CMD)
#define mfc_getlb(ls, ea, lsa, size, tag, tid, rid) \
  SPU_EMU_C_LIST(ls, ea, lsa, size, tag, tid, rid, MFC_GETLB_CMD)
#define mfc_getllar(ls, ea, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, 128, 0, tid, rid, MFC_GETLLAR_CMD)
#define mfc_putllc(ls, ea, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, 128, 0, tid, rid, MFC_PUTLLC_CMD)
#define mfc_putlluc(ls, ea, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, 128, 0, tid, rid, MFC_PUTLLUC_CMD)
#define mfc_putqlluc(ls, ea, tag, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, 128, tag, tid, rid, MFC_PUTQLLUC_CMD)
#define mfc_sndsig(ls, ea, tag, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, 4, tag, tid, rid, MFC_SNDSIG_CMD)
#define mfc_sndsigb(ls, ea, tag, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, 4, tag, tid, rid, MFC_SNDSIGB_CMD)
#define mfc_sndsigf(ls, ea, tag, tid, rid) SPU_EMU_C_TRANSFER(ls, ea, 4, tag, tid, rid, MFC_SNDSIGF_CMD)
#define mfc_barrier(tag) SPU_EMU_C_DMA(0, 0, 0, 0, tag, 0, 0, MFC_BARRIER_CMD)
#define mfc_eieio(tag, tid, rid) SPU_EMU_C_DMA(0, 0, 0, 0, tag, tid, rid, MFC_EIEIO_CMD)
#define mfc_sync(tag) SPU_EMU_C_DMA(0, 0, 0, 0, tag, 0, 0, MFC_SYNC_CMD)
#define mfc_sdcrt(ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(0, ea, size, tag, tid, rid, MFC_SDCRT_CMD)
#define mfc_sdcrtst(ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(0, ea, size, tag, tid, rid, MFC_SDCRTST_CMD)
#define mfc_sdcrz(ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(0, ea, size, tag, tid, rid, MFC_SDCRZ_CMD)
#define mfc_sdcrst(ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(0, ea, size, tag, tid, rid, MFC_SDCRST_CMD)
#define mfc_sdcrf(ea, size, tag, tid, rid) SPU_EMU_C_TRANSFER(0, ea, size, tag, tid, rid, MFC_SDCRF_CMD)

#define SPU_EMU_C_READ(channel) spu_emu_c_read_channel(channel, __FILE__, __LINE__)
#define SPU_EMU_C_WRITE(channel, value) spu_emu_c_write_channel(channel, value, __FILE__, __LINE__)
#define SPU_EMU_C_COUNT(channel) spu_emu_c_channel_count(channel, __FILE__, __LINE__)

#define mfc_stat_cmd_queue() SPU_EMU_C_COUNT(MFC_Cmd)
#define mfc_write_tag_mask(value) SPU_EMU_C_WRITE(MFC_WrTagMask, value)
#define mfc_read_tag_mask() SPU_EMU_C_READ(MFC_RdTagMask)
#define mfc_write_tag_update(value) SPU_EMU_C_WRITE(MFC_WrTagUpdate, value)
#define mfc_stat_tag_update() SPU_EMU_C_COUNT(MFC_WrTagUpdate)
#define mfc_read_tag_status() SPU_EMU_C_READ(MFC_RdTagStat)
#define mfc_stat_tag_status() SPU_EMU_C_COUNT(MFC_RdTagStat)
#define mfc_read_list_stall_status() SPU_EMU_C_READ(MFC_RdListStallStat)
#define mfc_stat_list_stall_status() SPU_EMU_C_COUNT(MFC_RdListStallStat)
#define mfc_write_list_stall_ack(value) SPU_EMU_C_WRITE(MFC_WrListStallAck, value)
#define mfc_read_atomic_status() SPU_EMU_C_READ(MFC_RdAtomicStat)
#define mfc_stat_atomic_status() SPU_EMU_C_COUNT(MFC_RdAtomicStat)
#define mfc_stat_multi_src_sync_request() SPU_EMU_C_COUNT(MFC_WrMSSyncReq)
#define spu_read_signal1() SPU_EMU_C_READ(SPU_RdSigNotify1)
#define spu_stat_signal1() SPU_EMU_C_COUNT(SPU_RdSigNotify1)
#define spu_read_signal2() SPU_EMU_C_READ(SPU_RdSigNotify2)
#define spu_stat_signal2() SPU_EMU_C_COUNT(SPU_RdSigNotify2)
#define spu_read_in_mbox() SPU_EMU_C_READ(SPU_RdInMbox)
#define spu_stat_in_mbox() SPU_EMU_C_COUNT(SPU_RdInMbox)
#define spu_write_out_mbox(value) SPU_EMU_C_WRITE(SPU_WrOutMbox, value)
#define spu_stat_out_mbox() SPU_EMU_C_COUNT(SPU_WrOutMbox)
#define spu_write_out_intr_mbox(value) SPU_EMU_C_WRITE(SPU_WrOutIntrMbox, value)
#define spu_stat_out_intr_mbox() SPU_EMU_C_COUNT(SPU_WrOutIntrMbox)
#define spu_read_decrementer() SPU_EMU_C_READ(SPU_RdDec)
#define spu_write_decrementer(value) SPU_EMU_C_WRITE(SPU_WrDec, value)
#define spu_read_event_status() SPU_EMU_C_READ(SPU_RdEventStat)
#define spu_stat_event_status() SPU_EMU_C_COUNT(SPU_RdEventStat)
#define spu_write_event_mask(value) SPU_EMU_C_WRITE(SPU_WrEventMask, value)
#define spu_write_event_ack(value) SPU_EMU_C_WRITE(SPU_WrEventAck, value)
#define spu_read_event_mask() SPU_EMU_C_READ(SPU_RdEventMask)
#define spu_read_machine_status() SPU_EMU_C_READ(SPU_RdMachStat)
#define spu_write_srr0(value) SPU_EMU_C_WRITE(SPU_WrSRR0, value)
#define spu_read_srr0() SPU_EMU_C_READ(SPU_RdSRR0)
#define mfc_write_multi_src_sync_request() SPU_EMU_C_WRITE(MFC_WrMSSyncReq, 0)
#define mfc_write_tag_update_immediate() mfc_write_tag_update(MFC_TAG_UPDATE_IMMEDIATE)
#define mfc_write_tag_update_any() mfc_write_tag_update(MFC_TAG_UPDATE_ANY)
#define mfc_write_tag_update_all() mfc_write_tag_update(MFC_TAG_UPDATE_ALL)
#define mfc_read_tag_status_immediate() (mfc_write_tag_update_immediate(), mfc_read_tag_status())
#define mfc_read_tag_status_any() (mfc_write_tag_update_any(), mfc_read_tag_status())
#define mfc_read_tag_status_all() (mfc_write_tag_update_all(), mfc_read_tag_status())

#define __mfc_multi_tag_reserve(count) spu_emu_c_reserve_tags(count)
#define __mfc_multi_tag_release(tag, count) spu_emu_c_release_tags(tag, count)
#define __mfc_tag_reserve() spu_emu_c_reserve_tags(1)
#define __mfc_tag_release(tag) spu_emu_c_release_tags(tag, 1)
#define mfc_multi_tag_reserve(count) spu_emu_c_reserve_tags(count)
#define mfc_multi_tag_release(tag, count) spu_emu_c_release_tags(tag, count)
#define mfc_tag_reserve() spu_emu_c_reserve_tags(1)
#define mfc_tag_release(tag) spu_emu_c_release_tags(tag, 1)

// SPU interrupts do not exist on the host engine, so a critical section has nothing to keep out.
#define mfc_begin_critical_section() 0U
#define mfc_end_critical_section(state) ((void)(state))

#endif
