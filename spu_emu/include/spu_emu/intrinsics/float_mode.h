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

#include <xmmintrin.h>

namespace spu_emu {

constexpr unsigned int spu_mxcsr = 0xFFC0;

// Sets spu_mxcsr on the current thread for this object's life and restores what was there before.
class SpuFloatMode {
 public:
  SpuFloatMode() : saved_(_mm_getcsr()) { _mm_setcsr(spu_mxcsr); }
  ~SpuFloatMode() { _mm_setcsr(saved_); }
  SpuFloatMode(const SpuFloatMode&) = delete;
  SpuFloatMode& operator=(const SpuFloatMode&) = delete;

 private:
  unsigned int saved_;
};

}  // namespace spu_emu

#endif
