// spu_intrinsics.h in C. The intrinsics themselves have overloads, which C has not: spu-emu-compile brings in
// intrinsic_macros.h behind the preprocessor, so that `spu_add(a, (vec_int4){1, 2, 3, 4})` is one call of two
// arguments as with the SPU's compiler. Each is a function of the program's runtime, not inline code.
#ifndef SPU_EMU_C_VECTORS_H
#define SPU_EMU_C_VECTORS_H

#ifndef SPU_EMU_TRANSLATED
#error "SPU sources in C are compiled by add_spu_program, or by spu-emu-compile before the compiler"
#endif

#include "vec_types.h"

#include "spu_emu/c/casts.h"
#include "spu_emu/c/services.h"
#include "spu_emu/channel_numbers.h"
#include "spu_emu/special_values.h"

// One register, whatever is in it: four words in the order of the host.
typedef struct {
  vec_uint4 spu_emu_words;
} qword;

#define SPU_EMU_C0(name, row, result) extern result spu_emu_c_##name##_##row(void);
#define SPU_EMU_C1(name, row, result, a) extern result spu_emu_c_##name##_##row(a);
#define SPU_EMU_C2(name, row, result, a, b) extern result spu_emu_c_##name##_##row(a, b);
#define SPU_EMU_C3(name, row, result, a, b, c) extern result spu_emu_c_##name##_##row(a, b, c);
#include "spu_emu/c/intrinsic_list.h"
#undef SPU_EMU_C0
#undef SPU_EMU_C1
#undef SPU_EMU_C2
#undef SPU_EMU_C3

#define SPU_EMU_DECLARE_CASTS(type)                 \
  extern qword spu_emu_qword_of_##type(type value); \
  extern type spu_emu_##type##_of_qword(qword value);
SPU_EMU_EVERY_VECTOR(SPU_EMU_DECLARE_CASTS)
extern qword spu_emu_qword_of_qword(qword value);
extern qword spu_emu_qword_of_no_vector()
    __attribute__((error("a cast to a vector type of what is no vector")));
#undef SPU_EMU_DECLARE_CASTS

// Tells spu-emu-compile that the source uses intrinsics.
extern const char spu_emu_c_intrinsics_are_declared;

#endif
