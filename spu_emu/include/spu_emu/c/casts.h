// What a cast between vectors becomes in C: to a qword by the operand's type, and from there.
#ifndef SPU_EMU_C_CASTS_H
#define SPU_EMU_C_CASTS_H

#define SPU_EMU_EVERY_VECTOR(use)                                                                \
  use(vec_uchar16) use(vec_char16) use(vec_ushort8) use(vec_short8) use(vec_uint4) use(vec_int4) \
      use(vec_ullong2) use(vec_llong2) use(vec_float4) use(vec_double2)

#define SPU_EMU_CHOICE(type) , type : spu_emu_qword_of_##type
#define SPU_EMU_TO_QWORD(...)                                                                 \
  __extension__({                                                                             \
    __auto_type spu_emu_operand = (__VA_ARGS__);                                              \
    _Generic(spu_emu_operand, qword                                                           \
             : spu_emu_qword_of_qword SPU_EMU_EVERY_VECTOR(SPU_EMU_CHOICE))(spu_emu_operand); \
  })

#define spu_emu_cast_vec_uchar16(...) spu_emu_vec_uchar16_of_qword(SPU_EMU_TO_QWORD(__VA_ARGS__))
#define spu_emu_cast_vec_char16(...) spu_emu_vec_char16_of_qword(SPU_EMU_TO_QWORD(__VA_ARGS__))
#define spu_emu_cast_vec_ushort8(...) spu_emu_vec_ushort8_of_qword(SPU_EMU_TO_QWORD(__VA_ARGS__))
#define spu_emu_cast_vec_short8(...) spu_emu_vec_short8_of_qword(SPU_EMU_TO_QWORD(__VA_ARGS__))
#define spu_emu_cast_vec_uint4(...) spu_emu_vec_uint4_of_qword(SPU_EMU_TO_QWORD(__VA_ARGS__))
#define spu_emu_cast_vec_int4(...) spu_emu_vec_int4_of_qword(SPU_EMU_TO_QWORD(__VA_ARGS__))
#define spu_emu_cast_vec_ullong2(...) spu_emu_vec_ullong2_of_qword(SPU_EMU_TO_QWORD(__VA_ARGS__))
#define spu_emu_cast_vec_llong2(...) spu_emu_vec_llong2_of_qword(SPU_EMU_TO_QWORD(__VA_ARGS__))
#define spu_emu_cast_vec_float4(...) spu_emu_vec_float4_of_qword(SPU_EMU_TO_QWORD(__VA_ARGS__))
#define spu_emu_cast_vec_double2(...) spu_emu_vec_double2_of_qword(SPU_EMU_TO_QWORD(__VA_ARGS__))
#define spu_emu_cast_qword(...) SPU_EMU_TO_QWORD(__VA_ARGS__)

// A cast to __typeof__(x), which may be no vector; then the branch that is not chosen must be one that a
// compiler takes.
#define SPU_EMU_IS_VECTOR(type) , type : 1
#define SPU_EMU_FROM_QWORD(type) , type : spu_emu_##type##_of_qword
#define SPU_EMU_ANY_TO_QWORD(...)                                                   \
  __extension__({                                                                   \
    __auto_type spu_emu_operand = (__VA_ARGS__);                                    \
    _Generic(spu_emu_operand, qword                                                 \
             : spu_emu_qword_of_qword SPU_EMU_EVERY_VECTOR(SPU_EMU_CHOICE), default \
             : spu_emu_qword_of_no_vector)(spu_emu_operand);                        \
  })
#define spu_emu_cast_as(type, ...)                                                                           \
  __builtin_choose_expr(_Generic(*(type*)0, qword : 1 SPU_EMU_EVERY_VECTOR(SPU_EMU_IS_VECTOR), default : 0), \
                        _Generic(*(type*)0, qword                                                            \
                                 : spu_emu_qword_of_qword SPU_EMU_EVERY_VECTOR(SPU_EMU_FROM_QWORD), default  \
                                 : spu_emu_qword_of_qword)(SPU_EMU_ANY_TO_QWORD(__VA_ARGS__)),               \
                        (type)(__VA_ARGS__))

#endif
