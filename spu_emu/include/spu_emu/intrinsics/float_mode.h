// The floating-point environment an emulated SPU runs under, and how to enter it on a thread.
//
// Single-precision intrinsics rely on the calling thread's MXCSR being spu_mxcsr: rounding toward zero,
// denormal operands read as zero, denormal results flushed, exceptions masked. The host engine sets it around
// every SPU program; a test or tool that calls intrinsics on its own thread holds a SpuFloatMode for as long.
// Compile SPU sources with -frounding-math -ffp-contract=off, or the compiler folds constants by its own
// rounding. What it still folds are operations that are exact: on a denormal constant, which an SPU would
// read as zero.
#ifndef SPU_EMU_INTRINSICS_FLOAT_MODE_H
#define SPU_EMU_INTRINSICS_FLOAT_MODE_H

#ifdef __SSE4_1__
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace spu_emu {

#ifdef __SSE4_1__
using FloatControl = unsigned int;

constexpr FloatControl spu_mxcsr = 0xFFC0;
constexpr FloatControl spu_float_control = spu_mxcsr;

inline FloatControl float_control() {
  return _mm_getcsr();
}
inline void set_float_control(FloatControl control) {
  _mm_setcsr(control);
}
#else
// Elsewhere the rounding is the whole of it: the intrinsics treat denormals themselves.
using FloatControl = int;

constexpr FloatControl spu_float_control = FE_TOWARDZERO;

inline FloatControl float_control() {
  return std::fegetround();
}
inline void set_float_control(FloatControl control) {
  std::fesetround(control);
}
#endif

// Sets spu_float_control on the current thread for this object's life and restores what was there before.
class SpuFloatMode {
 public:
  SpuFloatMode() : saved_(float_control()) { set_float_control(spu_float_control); }
  ~SpuFloatMode() { set_float_control(saved_); }
  SpuFloatMode(const SpuFloatMode&) = delete;
  SpuFloatMode& operator=(const SpuFloatMode&) = delete;

 private:
  FloatControl saved_;
};

}  // namespace spu_emu

#endif
