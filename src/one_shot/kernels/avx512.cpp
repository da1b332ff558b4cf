#include "engines/stream/kernels/lanes_avx512.h"
#include "one_shot/kernels/cross_body.h"

namespace cellsweep::one_shot {

constinit const CrossKernel kAvx512Cross = cross_pairs<stream::Avx512Lanes>;

}  // namespace cellsweep::one_shot
