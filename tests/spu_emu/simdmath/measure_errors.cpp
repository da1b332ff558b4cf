// Prints the largest errors of all functions: measure_errors DENSITY [PPU COMMAND [FUNCTION]], a row for
// each: its name, the error on the SPU, that on the PPU or a -, and the arguments and results of both.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "simdmath/accuracy.h"
#include "simdmath/ppu_evaluator.h"

namespace {

using namespace simdmath_test;

void print_errors(const Reference& reference, const std::string& function, int density,
                  const std::string& ppu) {
  const bool is_float = function.back() == '4';
  const Accuracy spu =
      measure(reference, function, is_float ? kSpuFloat : kSpuDouble, evaluate_precisely_on_host, density);
  std::printf("%s %.3f ", function.c_str(), spu.error);
  if (ppu.empty()) {
    std::printf("- %s\n", spu.worst.c_str());
    return;
  }
  const Accuracy other = measure(
      reference, function, is_float ? kPpuFloat : kPpuDouble,
      [&ppu](unsigned number, const std::vector<Call>& calls) { return evaluate_on_ppu(ppu, number, calls); },
      density);
  std::printf("%.3f %s; PPU: %s\n", other.error, spu.worst.c_str(), other.worst.c_str());
}

}  // namespace

int main(int count, char** arguments) {
  const int density = count > 1 ? std::atoi(arguments[1]) : 16;
  const std::string ppu = count > 2 ? arguments[2] : "";
  const std::string only = count > 3 ? arguments[3] : "";
  const auto& names = function_names();
  for (const Reference& reference : references()) {
    for (const char* ending : {"f4", "d2"}) {
      const std::string function = reference.name + ending;
      if ((only.empty() || only == function) &&
          std::find(names.begin(), names.end(), function) != names.end())
        print_errors(reference, function, density, ppu);
    }
  }
  return 0;
}
