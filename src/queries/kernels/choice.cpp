#include "engines/stream/kernels/kernel.h"
#include "queries/kernels/sets.h"

namespace cellsweep::queries {

const QueryKernels& query_kernels(VectorIsa isa) {
#ifdef CELLSWEEP_X86_KERNELS
  const stream::Kernels* const kernels = stream::find_kernels(isa);
  const VectorIsa there = kernels != nullptr ? kernels->isa : VectorIsa::portable;
  if (there == VectorIsa::avx512) return kAvx512Queries;
  if (there == VectorIsa::avx2) return kAvx2Queries;
#else
  static_cast<void>(isa);
#endif
  return kPortableQueries;
}

}  // namespace cellsweep::queries
