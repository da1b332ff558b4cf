#include "engines/stream/kernels/kernel.h"
#include "queries/kernels/sets.h"

namespace cellsweep::queries {

namespace {

const QueryKernels& choose(VectorIsa isa) {
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

}  // namespace

const QueryKernels& query_kernels(VectorIsa isa) {
  // What most ask for; to look at the machine anew would be a tenth of a short question.
  static const QueryKernels& best = choose(VectorIsa::best);
  return isa == best.isa || isa == VectorIsa::best ? best : choose(isa);
}

}  // namespace cellsweep::queries
