// Compiled twice, with SPU_EMU_PRECISE and without.
#define __SPU__ 1
#define SPU_EMU_NO_VECTOR_KEYWORD 1
#include <spu_intrinsics.h>

#include "simdmath/evaluate.h"
#include "simdmath/evaluator.h"

#include <cstdlib>
#include <cstring>

namespace simdmath_test {

namespace {

std::vector<Result> evaluate(unsigned function, const std::vector<Call>& calls) {
  std::vector<Result> results(calls.size());
  const spu_emu::SpuFloatMode mode;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    Register in[kArguments];
    Register out[kResults] = {};
    std::memcpy(in, &calls[i], sizeof in);
    evaluators[function](in, out);
    std::memcpy(&results[i], out, sizeof out);
  }
  return results;
}

}  // namespace

#ifdef SPU_EMU_PRECISE
std::vector<Result> evaluate_precisely_on_host(unsigned function, const std::vector<Call>& calls) {
  return evaluate(function, calls);
}
#else
std::vector<Result> evaluate_on_host(unsigned function, const std::vector<Call>& calls) {
  return evaluate(function, calls);
}

const std::vector<std::string>& function_names() {
#define SM_1(header, result, name, A) #name,
#define SM_2(header, result, name, A, B) #name,
#define SM_3(header, result, name, A, B, C) #name,
#define SM_1P(header, result, name, A, P) #name,
#define SM_2P(header, result, name, A, B, P) #name,
#define SM_PP(header, name, A) #name,
  static const std::vector<std::string> names = {
#include <simdmath/functions.def>
  };
  return names;
}

unsigned number_of(const std::string& name) {
  const auto& names = function_names();
  for (unsigned i = 0; i < names.size(); ++i) {
    if (names[i] == name) return i;
  }
  std::abort();
}
#endif

}  // namespace simdmath_test
