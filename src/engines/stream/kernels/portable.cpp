#include "engines/stream/kernels/body.h"
#include "engines/stream/kernels/lanes_portable.h"
#include "engines/stream/kernels/sets.h"

namespace cellsweep::stream {
constinit const Kernels kPortableKernels = make_kernels<PortableLanes>(VectorIsa::portable, "portable");

}  // namespace cellsweep::stream
