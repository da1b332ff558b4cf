/* The numbers of the MFC: commands, tag queries and limits, for both sides. */
#ifndef SPU_EMU_CBE_MFC_H
#define SPU_EMU_CBE_MFC_H

#ifdef __SPU__
#include <spu_mfcio.h>
#else

#define MFC_PUT_CMD 0x20
#define MFC_PUTB_CMD 0x21
#define MFC_PUTF_CMD 0x22
#define MFC_PUTL_CMD 0x24
#define MFC_PUTLB_CMD 0x25
#define MFC_PUTLF_CMD 0x26
#define MFC_GET_CMD 0x40
#define MFC_GETB_CMD 0x41
#define MFC_GETF_CMD 0x42
#define MFC_GETL_CMD 0x44
#define MFC_GETLB_CMD 0x45
#define MFC_GETLF_CMD 0x46
#define MFC_SDCRT_CMD 0x80
#define MFC_SDCRTST_CMD 0x81
#define MFC_SDCRZ_CMD 0x89
#define MFC_SDCRST_CMD 0x8d
#define MFC_SDCRF_CMD 0x8f
#define MFC_SNDSIG_CMD 0xa0
#define MFC_SNDSIGB_CMD 0xa1
#define MFC_SNDSIGF_CMD 0xa2
#define MFC_PUTLLUC_CMD 0xb0
#define MFC_PUTLLC_CMD 0xb4
#define MFC_PUTQLLUC_CMD 0xb8
#define MFC_BARRIER_CMD 0xc0
#define MFC_EIEIO_CMD 0xc8
#define MFC_SYNC_CMD 0xcc
#define MFC_GETLLAR_CMD 0xd0

/* Of the PPU: they start the SPU when they are done. */
#define MFC_PUTS_CMD 0x28
#define MFC_PUTBS_CMD 0x29
#define MFC_PUTFS_CMD 0x2a
#define MFC_GETS_CMD 0x48
#define MFC_GETBS_CMD 0x49
#define MFC_GETFS_CMD 0x4a

#define MFC_TAG_UPDATE_IMMEDIATE 0
#define MFC_TAG_UPDATE_ANY 1
#define MFC_TAG_UPDATE_ALL 2

#define MFC_MIN_DMA_SIZE 1
#define MFC_MAX_DMA_SIZE 16384
#define MFC_MIN_DMA_LIST_ELEMENTS 1
#define MFC_MAX_DMA_LIST_ELEMENTS 2048

#endif

#endif
