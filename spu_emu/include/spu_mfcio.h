// MFC and channel functions of SPU programs, by the SDK's names.
//
// Each takes the caller's file and line as defaulted arguments, so that a fault names SPU source. Addresses
// `ls` are pointers into the local store, `ea` effective addresses as 64-bit numbers, sizes are in bytes.
#ifndef SPU_EMU_SPU_MFCIO_H
#define SPU_EMU_SPU_MFCIO_H

#include <spu_intrinsics.h>

#include "spu_emu/mfc_opcodes.h"

#define MFC_MIN_DMA_SIZE 1
#define MFC_MAX_DMA_SIZE 16384
#define MFC_MIN_DMA_LIST_ELEMENTS 1
#define MFC_MAX_DMA_LIST_ELEMENTS 2048
#define MFC_MIN_DMA_LIST_SIZE 8
#define MFC_MAX_DMA_LIST_SIZE 16384
#define MFC_TAG_INVALID 0xFFFFFFFFU
#define MFC_TAG_VALID 0U

#ifndef __cplusplus
#include "spu_emu/c/mfcio.h"
#else

#include <cstdint>

#include "spu_emu/channels.h"

/// One element of a DMA list. The words have the values they have on the Cell (notify is the first word's
/// highest bit), whatever the byte order of the host, so lists written word by word work too.
struct mfc_list_element_t {
  mfc_list_element_t() = default;
  constexpr mfc_list_element_t(unsigned int notify_, unsigned int reserved_, unsigned int size_,
                               unsigned int eal_)
      : size(size_ & 0x7fffU), reserved(reserved_ & 0xffffU), notify(notify_ & 1U), eal(eal_) {}

  unsigned int size : 15;
  unsigned int reserved : 16;
  unsigned int notify : 1;
  unsigned int eal;
};
static_assert(sizeof(mfc_list_element_t) == 8, "a list element is two words");
using mfc_list_element = mfc_list_element_t;

/// Class ids and command code in one word; the emulation ignores the ids.
constexpr unsigned int MFC_CMD_WORD(unsigned int tid, unsigned int rid, unsigned int cmd) {
  return (tid << 24) | (rid << 16) | cmd;
}

constexpr unsigned int mfc_ea2h(unsigned long long ea) {
  return static_cast<unsigned int>(ea >> 32);
}
constexpr unsigned int mfc_ea2l(unsigned long long ea) {
  return static_cast<unsigned int>(ea);
}
constexpr unsigned long long mfc_hl2ea(unsigned int high, unsigned int low) {
  return (static_cast<unsigned long long>(high) << 32) | low;
}
constexpr unsigned long long mfc_ceil128(unsigned long long value) {
  return (value + 127) & ~127ULL;
}

/// The parameter list's end that every function here has.
#define SPU_EMU_WHERE const char *file = __builtin_FILE(), int line = __builtin_LINE()

/// put, putf, putb, get, getf, getb: one transfer between `ls` and `ea`.
#define SPU_EMU_TRANSFER(name, opcode)                                                                   \
  inline void name(volatile void* ls, unsigned long long ea, unsigned int size, unsigned int tag,        \
                   unsigned int tid, unsigned int rid, SPU_EMU_WHERE) {                                  \
    spu_mfcdma64(ls, mfc_ea2h(ea), mfc_ea2l(ea), size, tag, MFC_CMD_WORD(tid, rid, opcode), file, line); \
  }
SPU_EMU_TRANSFER(mfc_put, MFC_PUT_CMD)
SPU_EMU_TRANSFER(mfc_putf, MFC_PUTF_CMD)
SPU_EMU_TRANSFER(mfc_putb, MFC_PUTB_CMD)
SPU_EMU_TRANSFER(mfc_get, MFC_GET_CMD)
SPU_EMU_TRANSFER(mfc_getf, MFC_GETF_CMD)
SPU_EMU_TRANSFER(mfc_getb, MFC_GETB_CMD)
#undef SPU_EMU_TRANSFER

namespace spu_emu {

/// The LS address of a list as the command carries it: the low half of its pointer, or the number itself.
inline unsigned int list_address(const volatile void* list) {
  return static_cast<unsigned int>(reinterpret_cast<std::uintptr_t>(list));
}
constexpr unsigned int list_address(unsigned int list) {
  return list;
}

}  // namespace spu_emu

/// putl and getl with variants: `lsa` is the list (pointer or LS address), `size` its bytes; the high half of
/// `ea` goes before every element's address.
#define SPU_EMU_LIST(name, opcode)                                                                          \
  template <class List>                                                                                     \
  inline void name(volatile void* ls, unsigned long long ea, List lsa, unsigned int size, unsigned int tag, \
                   unsigned int tid, unsigned int rid, SPU_EMU_WHERE) {                                     \
    spu_mfcdma64(ls, mfc_ea2h(ea), spu_emu::list_address(lsa), size, tag, MFC_CMD_WORD(tid, rid, opcode),   \
                 file, line);                                                                               \
  }
SPU_EMU_LIST(mfc_putl, MFC_PUTL_CMD)
SPU_EMU_LIST(mfc_putlf, MFC_PUTLF_CMD)
SPU_EMU_LIST(mfc_putlb, MFC_PUTLB_CMD)
SPU_EMU_LIST(mfc_getl, MFC_GETL_CMD)
SPU_EMU_LIST(mfc_getlf, MFC_GETLF_CMD)
SPU_EMU_LIST(mfc_getlb, MFC_GETLB_CMD)
#undef SPU_EMU_LIST

/// Atomic commands on the 128-byte line of `ea`; their status is read with mfc_read_atomic_status.
#define SPU_EMU_ATOMIC(name, opcode)                                                                  \
  inline void name(volatile void* ls, unsigned long long ea, unsigned int tid, unsigned int rid,      \
                   SPU_EMU_WHERE) {                                                                   \
    spu_mfcdma64(ls, mfc_ea2h(ea), mfc_ea2l(ea), 128, 0, MFC_CMD_WORD(tid, rid, opcode), file, line); \
  }
SPU_EMU_ATOMIC(mfc_getllar, MFC_GETLLAR_CMD)
SPU_EMU_ATOMIC(mfc_putllc, MFC_PUTLLC_CMD)
SPU_EMU_ATOMIC(mfc_putlluc, MFC_PUTLLUC_CMD)
#undef SPU_EMU_ATOMIC

/// Queued unconditional store of a line; done when its tag is.
inline void mfc_putqlluc(volatile void* ls, unsigned long long ea, unsigned int tag, unsigned int tid,
                         unsigned int rid, SPU_EMU_WHERE) {
  spu_mfcdma64(ls, mfc_ea2h(ea), mfc_ea2l(ea), 128, tag, MFC_CMD_WORD(tid, rid, MFC_PUTQLLUC_CMD), file,
               line);
}

/// Sends 4 bytes to a signal register of another SPE.
#define SPU_EMU_SIGNAL(name, opcode)                                                                  \
  inline void name(volatile void* ls, unsigned long long ea, unsigned int tag, unsigned int tid,      \
                   unsigned int rid, SPU_EMU_WHERE) {                                                 \
    spu_mfcdma64(ls, mfc_ea2h(ea), mfc_ea2l(ea), 4, tag, MFC_CMD_WORD(tid, rid, opcode), file, line); \
  }
SPU_EMU_SIGNAL(mfc_sndsig, MFC_SNDSIG_CMD)
SPU_EMU_SIGNAL(mfc_sndsigb, MFC_SNDSIGB_CMD)
SPU_EMU_SIGNAL(mfc_sndsigf, MFC_SNDSIGF_CMD)
#undef SPU_EMU_SIGNAL

/// Ordering commands: the barrier for all tags, eieio and sync for theirs.
inline void mfc_barrier(unsigned int tag, SPU_EMU_WHERE) {
  spu_mfcdma32(nullptr, 0, 0, tag, MFC_BARRIER_CMD, file, line);
}
inline void mfc_eieio(unsigned int tag, unsigned int tid, unsigned int rid, SPU_EMU_WHERE) {
  spu_mfcdma32(nullptr, 0, 0, tag, MFC_CMD_WORD(tid, rid, MFC_EIEIO_CMD), file, line);
}
inline void mfc_sync(unsigned int tag, SPU_EMU_WHERE) {
  spu_mfcdma32(nullptr, 0, 0, tag, MFC_SYNC_CMD, file, line);
}

/// Data cache commands: sdcrz zeroes the lines of the range, the others change nothing here.
#define SPU_EMU_CACHE(name, opcode)                                                                    \
  inline void name(unsigned long long ea, unsigned int size, unsigned int tag, unsigned int tid,       \
                   unsigned int rid, SPU_EMU_WHERE) {                                                  \
    spu_mfcdma64(nullptr, mfc_ea2h(ea), mfc_ea2l(ea), size, tag, MFC_CMD_WORD(tid, rid, opcode), file, \
                 line);                                                                                \
  }
SPU_EMU_CACHE(mfc_sdcrt, MFC_SDCRT_CMD)
SPU_EMU_CACHE(mfc_sdcrtst, MFC_SDCRTST_CMD)
SPU_EMU_CACHE(mfc_sdcrz, MFC_SDCRZ_CMD)
SPU_EMU_CACHE(mfc_sdcrst, MFC_SDCRST_CMD)
SPU_EMU_CACHE(mfc_sdcrf, MFC_SDCRF_CMD)
#undef SPU_EMU_CACHE

/// One function for each way a program uses a channel: read it, write it, count what it can take.
#define SPU_EMU_READ(name, channel)         \
  inline unsigned int name(SPU_EMU_WHERE) { \
    return spu_readch(channel, file, line); \
  }
#define SPU_EMU_WRITE(name, channel)                    \
  inline void name(unsigned int value, SPU_EMU_WHERE) { \
    spu_writech(channel, value, file, line);            \
  }
#define SPU_EMU_COUNT(name, channel)           \
  inline unsigned int name(SPU_EMU_WHERE) {    \
    return spu_readchcnt(channel, file, line); \
  }

SPU_EMU_COUNT(mfc_stat_cmd_queue, MFC_Cmd)
SPU_EMU_WRITE(mfc_write_tag_mask, MFC_WrTagMask)
SPU_EMU_READ(mfc_read_tag_mask, MFC_RdTagMask)
SPU_EMU_WRITE(mfc_write_tag_update, MFC_WrTagUpdate)
SPU_EMU_COUNT(mfc_stat_tag_update, MFC_WrTagUpdate)
SPU_EMU_READ(mfc_read_tag_status, MFC_RdTagStat)
SPU_EMU_COUNT(mfc_stat_tag_status, MFC_RdTagStat)
SPU_EMU_READ(mfc_read_list_stall_status, MFC_RdListStallStat)
SPU_EMU_COUNT(mfc_stat_list_stall_status, MFC_RdListStallStat)
SPU_EMU_WRITE(mfc_write_list_stall_ack, MFC_WrListStallAck)
SPU_EMU_READ(mfc_read_atomic_status, MFC_RdAtomicStat)
SPU_EMU_COUNT(mfc_stat_atomic_status, MFC_RdAtomicStat)
SPU_EMU_COUNT(mfc_stat_multi_src_sync_request, MFC_WrMSSyncReq)
SPU_EMU_READ(spu_read_signal1, SPU_RdSigNotify1)
SPU_EMU_COUNT(spu_stat_signal1, SPU_RdSigNotify1)
SPU_EMU_READ(spu_read_signal2, SPU_RdSigNotify2)
SPU_EMU_COUNT(spu_stat_signal2, SPU_RdSigNotify2)
SPU_EMU_READ(spu_read_in_mbox, SPU_RdInMbox)
SPU_EMU_COUNT(spu_stat_in_mbox, SPU_RdInMbox)
SPU_EMU_WRITE(spu_write_out_mbox, SPU_WrOutMbox)
SPU_EMU_COUNT(spu_stat_out_mbox, SPU_WrOutMbox)
SPU_EMU_WRITE(spu_write_out_intr_mbox, SPU_WrOutIntrMbox)
SPU_EMU_COUNT(spu_stat_out_intr_mbox, SPU_WrOutIntrMbox)
SPU_EMU_READ(spu_read_decrementer, SPU_RdDec)
SPU_EMU_WRITE(spu_write_decrementer, SPU_WrDec)
SPU_EMU_READ(spu_read_event_status, SPU_RdEventStat)
SPU_EMU_COUNT(spu_stat_event_status, SPU_RdEventStat)
SPU_EMU_WRITE(spu_write_event_mask, SPU_WrEventMask)
SPU_EMU_WRITE(spu_write_event_ack, SPU_WrEventAck)
SPU_EMU_READ(spu_read_event_mask, SPU_RdEventMask)
SPU_EMU_READ(spu_read_machine_status, SPU_RdMachStat)
SPU_EMU_WRITE(spu_write_srr0, SPU_WrSRR0)
SPU_EMU_READ(spu_read_srr0, SPU_RdSRR0)
#undef SPU_EMU_READ
#undef SPU_EMU_WRITE
#undef SPU_EMU_COUNT

inline void mfc_write_multi_src_sync_request(SPU_EMU_WHERE) {
  spu_writech(MFC_WrMSSyncReq, 0, file, line);
}

inline void mfc_write_tag_update_immediate(SPU_EMU_WHERE) {
  mfc_write_tag_update(MFC_TAG_UPDATE_IMMEDIATE, file, line);
}
inline void mfc_write_tag_update_any(SPU_EMU_WHERE) {
  mfc_write_tag_update(MFC_TAG_UPDATE_ANY, file, line);
}
inline void mfc_write_tag_update_all(SPU_EMU_WHERE) {
  mfc_write_tag_update(MFC_TAG_UPDATE_ALL, file, line);
}

/// Ask for the status of the tag mask and read it: done tags now, when any is done, when all are.
inline unsigned int mfc_read_tag_status_immediate(SPU_EMU_WHERE) {
  return spu_mfcstat(MFC_TAG_UPDATE_IMMEDIATE, file, line);
}
inline unsigned int mfc_read_tag_status_any(SPU_EMU_WHERE) {
  return spu_mfcstat(MFC_TAG_UPDATE_ANY, file, line);
}
inline unsigned int mfc_read_tag_status_all(SPU_EMU_WHERE) {
  return spu_mfcstat(MFC_TAG_UPDATE_ALL, file, line);
}

#undef SPU_EMU_WHERE

/// Tag manager: reserve gives a tag (the first of several neighbours) or MFC_TAG_INVALID, release gives
/// MFC_TAG_VALID or MFC_TAG_INVALID.
inline unsigned int __mfc_multi_tag_reserve(unsigned int count) {
  return spu_emu_services->reserve_tags(spu_emu_services->spe, count);
}
inline unsigned int __mfc_multi_tag_release(unsigned int tag, unsigned int count) {
  return spu_emu_services->release_tags(spu_emu_services->spe, tag, count);
}
inline unsigned int __mfc_tag_reserve() {
  return __mfc_multi_tag_reserve(1);
}
inline unsigned int __mfc_tag_release(unsigned int tag) {
  return __mfc_multi_tag_release(tag, 1);
}
inline unsigned int mfc_tag_reserve() {
  return __mfc_tag_reserve();
}
inline unsigned int mfc_tag_release(unsigned int tag) {
  return __mfc_tag_release(tag);
}
inline unsigned int mfc_multi_tag_reserve(unsigned int count) {
  return __mfc_multi_tag_reserve(count);
}
inline unsigned int mfc_multi_tag_release(unsigned int tag, unsigned int count) {
  return __mfc_multi_tag_release(tag, count);
}

/// SPU interrupts do not exist on the host engine, so a critical section has nothing to keep out.
inline unsigned int mfc_begin_critical_section() {
  return 0;
}
inline void mfc_end_critical_section(unsigned int) {}

#endif  // __cplusplus

#endif
