#include "queries/kernels/lanes_avx2.h"
#include "queries/kernels/sets.h"

namespace cellsweep::queries {

constinit const TreeKernels kAvx2Trees = make_tree_kernels<Avx2QueryLanes>();
constinit const QueryKernels kAvx2Queries =
    make_query_kernels<Avx2QueryLanes, Avx2QueryLanes, Avx2QueryLanes>(VectorIsa::avx2, kAvx2Trees);

}  // namespace cellsweep::queries
