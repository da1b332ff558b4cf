#include "engines/stream/kernels/lanes_avx2.h"
#include "one_shot/kernels/cross_body.h"

namespace cellsweep::one_shot {

constinit const CrossKernel kAvx2Cross = cross_pairs<stream::Avx2Lanes>;

}  // namespace cellsweep::one_shot
