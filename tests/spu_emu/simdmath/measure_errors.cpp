// Prints the largest errors of all functions: measure_errors DENSITY [NAME...]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "simdmath/accuracy.h"

int main(int count, char** arguments) {
  using namespace simdmath_test;
  const int density = count > 1 ? std::atoi(arguments[1]) : 16;
  for (const Reference& reference : references()) {
    for (const char* ending : {"f4", "d2"}) {
      const std::string name = reference.name + ending;
      bool wanted = count <= 2;
      for (int i = 2; i < count; ++i) wanted = wanted || name == arguments[i];
      const auto& names = function_names();
      if (!wanted || std::find(names.begin(), names.end(), name) == names.end()) continue;
      const Format& format = ending[0] == 'f' ? kSpuFloat : kSpuDouble;
      const Accuracy accuracy = measure(reference, name, format, evaluate_precisely_on_host, density);
      std::printf("%-12s %10.3f  %s\n", name.c_str(), accuracy.error, accuracy.worst.c_str());
    }
  }
  return 0;
}
