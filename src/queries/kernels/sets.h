/// @file
/// The tables of query kernels that this build has, each from a source file of its own.
#pragma once

#include "queries/kernels/kernel.h"

namespace cellsweep::queries {

extern const QueryKernels kPortableQueries;
extern const TreeKernels kPortableTrees;
#ifdef CELLSWEEP_X86_KERNELS
extern const QueryKernels kAvx2Queries;
extern const QueryKernels kAvx512Queries;
extern const TreeKernels kAvx2Trees;  ///< AVX-512 has none of its own
#endif

}  // namespace cellsweep::queries
