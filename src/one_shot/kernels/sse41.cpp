#include "engines/stream/kernels/lanes_sse41.h"
#include "one_shot/kernels/cross_body.h"

namespace cellsweep::one_shot {

constinit const CrossKernel kSse41Cross = cross_pairs<stream::Sse41Lanes>;

}  // namespace cellsweep::one_shot
