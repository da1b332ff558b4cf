#include "queries/kernels/lanes_avx2.h"
#include "queries/kernels/sets.h"

namespace cellsweep::queries {

constinit const QueryKernels kAvx2Queries =
    make_query_kernels<Avx2QueryLanes, Avx2QueryLanes, Avx2QueryLanes>(VectorIsa::avx2);

}  // namespace cellsweep::queries
