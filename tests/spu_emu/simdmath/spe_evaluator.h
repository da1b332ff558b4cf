// Functions of the SIMD math library evaluated by an SPU program.
#pragma once

#include <libspe2.h>

#include "simdmath/evaluator.h"

namespace simdmath_test {

std::vector<Result> evaluate_on_spe(spe_program_handle_t& program, unsigned function, const std::vector<Call>& calls);

}  // namespace simdmath_test
