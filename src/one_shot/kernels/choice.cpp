#include "one_shot/kernels/cross.h"

namespace cellsweep::one_shot {

CrossKernel find_cross_kernel(VectorIsa isa) {
#ifdef CELLSWEEP_X86_KERNELS
  switch (isa) {
    case VectorIsa::sse41:
      return kSse41Cross;
    case VectorIsa::avx2:
      return kAvx2Cross;
    case VectorIsa::avx512:
      return kAvx512Cross;
    default:
      break;
  }
#else
  static_cast<void>(isa);
#endif
  return kPortableCross;
}

}  // namespace cellsweep::one_shot
