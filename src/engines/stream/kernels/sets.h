/// @file
/// The kernel tables that this build has, each from a source file of its own.
///
/// Each is defined constinit: what filled it when the program starts would be compiled for its instruction
/// set.
#pragma once

#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {

extern const Kernels kPortableKernels;
#ifdef CELLSWEEP_X86_KERNELS
extern const Kernels kSse41Kernels;
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;
#endif

}  // namespace cellsweep::stream
