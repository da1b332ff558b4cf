// No error is larger than docs/simdmath.md says, for arguments of every exponent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "simdmath/accuracy.h"
#include "simdmath/ppu_evaluator.h"

namespace {

using namespace simdmath_test;

/// The limit in the table of the page: | `sinf4` | 2.0 | 1.2 | ..., of the SPU and of the PPU.
double stated_error(const std::string& function, int column) {
  std::ifstream page(SIMDMATH_PAGE);
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| `" + function + "` |", 0) != 0) continue;
    std::size_t start = line.find('|', 2);
    for (int i = 0; i < column; ++i) start = line.find('|', start + 1);
    std::istringstream cells(line.substr(start + 1));
    double error = -1;
    cells >> error;
    return error;
  }
  return -1;
}

/// How many samples of each exponent.
int density() {
  return std::getenv("CELLSWEEP_LONG_TESTS") != nullptr ? 2000 : 24;
}

struct Case {
  Reference reference;
  std::string function;
};

/// Of all functions with one of the endings.
std::vector<Case> cases(const std::vector<std::string>& endings) {
  std::vector<Case> result;
  const auto& names = function_names();
  for (const Reference& reference : references()) {
    for (const std::string& ending : endings) {
      const std::string function = reference.name + ending;
      if (std::find(names.begin(), names.end(), function) != names.end())
        result.push_back({reference, function});
    }
  }
  return result;
}

void check(const Case& test, const Format& format, int column, const Evaluate& evaluate) {
  const double limit = stated_error(test.function, column);
  ASSERT_GE(limit, 0) << test.function << " is not in the table of " << SIMDMATH_PAGE;
  const Accuracy accuracy = measure(test.reference, test.function, format, evaluate, density());
  EXPECT_GT(accuracy.samples, 1000U);
  EXPECT_LE(accuracy.error, limit) << accuracy.worst;
}

class AccuracyOf : public testing::TestWithParam<Case> {};

TEST_P(AccuracyOf, IsAsThePageStatesForEveryExponent) {
  const Format& format = GetParam().function.back() == '4' ? kSpuFloat : kSpuDouble;
  check(GetParam(), format, 0, evaluate_precisely_on_host);
}

INSTANTIATE_TEST_SUITE_P(Functions, AccuracyOf, testing::ValuesIn(cases({"f4", "d2"})), [](const auto& test) {
  return test.param.function + (test.param.reference.second ? "_second" : "");
});

#ifdef SIMDMATH_PPU64
class AccuracyOnPpuOf : public testing::TestWithParam<Case> {};

TEST_P(AccuracyOnPpuOf, IsAsThePageStatesForEveryExponent) {
  const Format& format = GetParam().function.back() == '4' ? kPpuFloat : kPpuDouble;
  for (const char* command : {SIMDMATH_PPU64, SIMDMATH_PPU32}) {
    check(GetParam(), format, 1, [command](unsigned function, const std::vector<Call>& calls) {
      return evaluate_on_ppu(command, function, calls);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Functions, AccuracyOnPpuOf, testing::ValuesIn(cases({"f4", "d2"})),
                         [](const auto& test) {
                           return test.param.function + (test.param.reference.second ? "_second" : "");
                         });
#endif

}  // namespace
