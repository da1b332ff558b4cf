/// @file
/// Instruction sets, by name. The kernels, each compiled for one of them, include nothing heavier.
#pragma once

namespace cellsweep {

/// The instruction set of vector kernels.
enum class VectorIsa {
  best,      ///< the widest that the processor has
  portable,  ///< plain C++, on any processor
  sse41,     ///< x86: four boxes at a time
  avx2,      ///< eight
  avx512     ///< sixteen
};

}  // namespace cellsweep
