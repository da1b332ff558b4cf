#include <array>

#include "engines/stream/kernels/sets.h"

namespace cellsweep::stream {
namespace {

#ifdef CELLSWEEP_X86_KERNELS
bool has(VectorIsa isa) {
  switch (isa) {
    case VectorIsa::sse41:
      return __builtin_cpu_supports("sse4.1") != 0;
    case VectorIsa::avx2:
      return __builtin_cpu_supports("avx2") != 0;
    case VectorIsa::avx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
             __builtin_cpu_supports("avx512vl") != 0;
    default:
      return true;
  }
}

// Widest first.
constexpr std::array kSets = {&kAvx512Kernels, &kAvx2Kernels, &kSse41Kernels, &kPortableKernels};
#else
bool has(VectorIsa) {
  return true;
}

constexpr std::array kSets = {&kPortableKernels};
#endif

}  // namespace

const Kernels* find_kernels(VectorIsa isa) {
  for (const Kernels* kernels : kSets) {
    if ((isa == VectorIsa::best || isa == kernels->isa) && has(kernels->isa)) return kernels;
  }
  return nullptr;
}

}  // namespace cellsweep::stream
