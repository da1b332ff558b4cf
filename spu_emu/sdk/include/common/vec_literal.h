/* Vectors written as constants, as the SDK's programs write them for every compiler. */
#ifndef SPU_EMU_VEC_LITERAL_H
#define SPU_EMU_VEC_LITERAL_H

#define VEC_LITERAL(type, ...) ((type){__VA_ARGS__})

#define VEC_SPLAT_U8(x) ((__vector unsigned char){x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x})
#define VEC_SPLAT_S8(x) ((__vector signed char){x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x})
#define VEC_SPLAT_U16(x) ((__vector unsigned short){x, x, x, x, x, x, x, x})
#define VEC_SPLAT_S16(x) ((__vector signed short){x, x, x, x, x, x, x, x})
#define VEC_SPLAT_U32(x) ((__vector unsigned int){x, x, x, x})
#define VEC_SPLAT_S32(x) ((__vector signed int){x, x, x, x})
#define VEC_SPLAT_F32(x) ((__vector float){x, x, x, x})
#ifdef __SPU__
#define VEC_SPLAT_U64(x) ((__vector unsigned long long){x, x})
#define VEC_SPLAT_S64(x) ((__vector signed long long){x, x})
#define VEC_SPLAT_F64(x) ((__vector double){x, x})
#endif

#endif
