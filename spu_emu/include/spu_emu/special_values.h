// The bits of spu_testsv's mask.
#ifndef SPU_EMU_SPECIAL_VALUES_H
#define SPU_EMU_SPECIAL_VALUES_H

#define SPU_SV_NEG_DENORM (1 << 0)
#define SPU_SV_POS_DENORM (1 << 1)
#define SPU_SV_NEG_ZERO (1 << 2)
#define SPU_SV_POS_ZERO (1 << 3)
#define SPU_SV_NEG_INFINITY (1 << 4)
#define SPU_SV_POS_INFINITY (1 << 5)
#define SPU_SV_NAN (1 << 6)

#endif
