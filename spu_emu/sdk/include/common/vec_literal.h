/* Vectors written as constants, as the SDK's programs write them for every compiler. */
#ifndef SPU_EMU_VEC_LITERAL_H
#define SPU_EMU_VEC_LITERAL_H

/* As `vector`, and a word that no compiler needs to know. */
#define SPU_EMU_QUADWORD_OF __attribute__((vector_size(16)))

#define VEC_LITERAL(type, ...) ((type){__VA_ARGS__})

#define VEC_SPLAT_U8(x) ((SPU_EMU_QUADWORD_OF unsigned char){x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x})
#define VEC_SPLAT_S8(x) ((SPU_EMU_QUADWORD_OF signed char){x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x})
#define VEC_SPLAT_U16(x) ((SPU_EMU_QUADWORD_OF unsigned short){x, x, x, x, x, x, x, x})
#define VEC_SPLAT_S16(x) ((SPU_EMU_QUADWORD_OF signed short){x, x, x, x, x, x, x, x})
#define VEC_SPLAT_U32(x) ((SPU_EMU_QUADWORD_OF unsigned int){x, x, x, x})
#define VEC_SPLAT_S32(x) ((SPU_EMU_QUADWORD_OF signed int){x, x, x, x})
#define VEC_SPLAT_F32(x) ((SPU_EMU_QUADWORD_OF float){x, x, x, x})
#ifdef __SPU__
#define VEC_SPLAT_U64(x) ((SPU_EMU_QUADWORD_OF unsigned long long){x, x})
#define VEC_SPLAT_S64(x) ((SPU_EMU_QUADWORD_OF signed long long){x, x})
#define VEC_SPLAT_F64(x) ((SPU_EMU_QUADWORD_OF double){x, x})
#endif

#endif
