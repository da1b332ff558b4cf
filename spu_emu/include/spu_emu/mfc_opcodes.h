// MFC command codes, tag update kinds, atomic status values and event bits, by the names of spu_mfcio.h.
#ifndef SPU_EMU_MFC_OPCODES_H
#define SPU_EMU_MFC_OPCODES_H

// The width that C++ may state is what C takes anyway.
#ifndef SPU_EMU_ENUM
#ifdef __cplusplus
#define SPU_EMU_ENUM enum : unsigned int
#else
#define SPU_EMU_ENUM enum
#endif
#endif

SPU_EMU_ENUM{MFC_PUT_CMD = 0x20,     MFC_PUTB_CMD = 0x21,    MFC_PUTF_CMD = 0x22,     MFC_PUTL_CMD = 0x24,
             MFC_PUTLB_CMD = 0x25,   MFC_PUTLF_CMD = 0x26,   MFC_GET_CMD = 0x40,      MFC_GETB_CMD = 0x41,
             MFC_GETF_CMD = 0x42,    MFC_GETL_CMD = 0x44,    MFC_GETLB_CMD = 0x45,    MFC_GETLF_CMD = 0x46,
             MFC_SDCRT_CMD = 0x80,   MFC_SDCRTST_CMD = 0x81, MFC_SDCRZ_CMD = 0x89,    MFC_SDCRST_CMD = 0x8d,
             MFC_SDCRF_CMD = 0x8f,   MFC_SNDSIG_CMD = 0xa0,  MFC_SNDSIGB_CMD = 0xa1,  MFC_SNDSIGF_CMD = 0xa2,
             MFC_PUTLLUC_CMD = 0xb0, MFC_PUTLLC_CMD = 0xb4,  MFC_PUTQLLUC_CMD = 0xb8, MFC_BARRIER_CMD = 0xc0,
             MFC_EIEIO_CMD = 0xc8,   MFC_SYNC_CMD = 0xcc,    MFC_GETLLAR_CMD = 0xd0};

SPU_EMU_ENUM{MFC_TAG_UPDATE_IMMEDIATE = 0, MFC_TAG_UPDATE_ANY = 1, MFC_TAG_UPDATE_ALL = 2};

SPU_EMU_ENUM{MFC_PUTLLC_STATUS = 1, MFC_PUTLLUC_STATUS = 2, MFC_GETLLAR_STATUS = 4};

SPU_EMU_ENUM{MFC_TAG_STATUS_UPDATE_EVENT = 0x0001,
             MFC_LIST_STALL_NOTIFY_EVENT = 0x0002,
             MFC_COMMAND_QUEUE_AVAILABLE_EVENT = 0x0008,
             MFC_IN_MBOX_AVAILABLE_EVENT = 0x0010,
             MFC_DECREMENTER_EVENT = 0x0020,
             MFC_OUT_INTR_MBOX_AVAILABLE_EVENT = 0x0040,
             MFC_OUT_MBOX_AVAILABLE_EVENT = 0x0080,
             MFC_SIGNAL_NOTIFY_2_EVENT = 0x0100,
             MFC_SIGNAL_NOTIFY_1_EVENT = 0x0200,
             MFC_LLR_LOST_EVENT = 0x0400,
             MFC_PRIV_ATTN_EVENT = 0x0800,
             MFC_MULTI_SRC_SYNC_EVENT = 0x1000};

#endif
