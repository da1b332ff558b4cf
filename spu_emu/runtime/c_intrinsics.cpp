// The vector intrinsics as functions that C sources call, one for each combination of argument types.
#include <spu_intrinsics.h>

#include "spu_emu/c/casts.h"

extern "C" {

#define SPU_EMU_C0(name, row, result) \
  result spu_emu_c_##name##_##row() { \
    return name();                    \
  }
#define SPU_EMU_C1(name, row, result, A) \
  result spu_emu_c_##name##_##row(A a) { \
    return name(a);                      \
  }
#define SPU_EMU_C2(name, row, result, A, B)   \
  result spu_emu_c_##name##_##row(A a, B b) { \
    return name(a, b);                        \
  }
#define SPU_EMU_C3(name, row, result, A, B, C)     \
  result spu_emu_c_##name##_##row(A a, B b, C c) { \
    return name(a, b, c);                          \
  }
#include "spu_emu/c/intrinsic_list.h"

#define SPU_EMU_DEFINE_CASTS(type)              \
  qword spu_emu_qword_of_##type(type value) {   \
    return qword(value);                        \
  }                                             \
  type spu_emu_##type##_of_qword(qword value) { \
    return type(value);                         \
  }
SPU_EMU_EVERY_VECTOR(SPU_EMU_DEFINE_CASTS)

qword spu_emu_qword_of_qword(qword value) {
  return value;
}

}  // extern "C"
