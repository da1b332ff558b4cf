// Functions of the SIMD math library evaluated by a program for the PPU, which an emulator runs.
#pragma once

#include "simdmath/evaluator.h"

namespace simdmath_test {

/// `command` runs the program, as in "qemu-ppc64 program". Functions that the SPU alone has are not there:
/// their numbers are the last.
std::vector<Result> evaluate_on_ppu(const std::string& command, unsigned function,
                                    const std::vector<Call>& calls);

}  // namespace simdmath_test
