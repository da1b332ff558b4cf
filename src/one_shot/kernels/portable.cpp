#include "engines/stream/kernels/lanes_portable.h"
#include "one_shot/kernels/cross_body.h"

namespace cellsweep::one_shot {

constinit const CrossKernel kPortableCross = cross_pairs<stream::PortableLanes>;

}  // namespace cellsweep::one_shot
