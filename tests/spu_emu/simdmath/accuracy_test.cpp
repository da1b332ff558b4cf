// No error is larger than docs/simdmath.md says, for arguments of every exponent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "simdmath/accuracy.h"

namespace {

using namespace simdmath_test;

/// The limit in the table of the page: | `sinf4` | 1.97 | ...
double stated_error(const std::string& function) {
  std::ifstream page(SIMDMATH_PAGE);
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| `" + function + "` |", 0) != 0) continue;
    std::istringstream cells(line.substr(line.find('|', 2) + 1));
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

std::vector<Case> cases() {
  std::vector<Case> result;
  const auto& names = function_names();
  for (const Reference& reference : references()) {
    for (const char* ending : {"f4", "d2"}) {
      const std::string function = reference.name + ending;
      if (std::find(names.begin(), names.end(), function) != names.end()) result.push_back({reference, function});
    }
  }
  return result;
}

class AccuracyOf : public testing::TestWithParam<Case> {};

TEST_P(AccuracyOf, IsAsThePageStatesForEveryExponent) {
  const auto& [reference, function] = GetParam();
  const Format& format = function.back() == '4' ? kSpuFloat : kSpuDouble;
  const double limit = stated_error(function);
  ASSERT_GE(limit, 0) << function << " is not in the table of " << SIMDMATH_PAGE;
  const Accuracy accuracy = measure(reference, function, format, evaluate_precisely_on_host, density());
  EXPECT_GT(accuracy.samples, 1000U);
  EXPECT_LE(accuracy.error, limit) << accuracy.worst;
}

INSTANTIATE_TEST_SUITE_P(Functions, AccuracyOf, testing::ValuesIn(cases()), [](const auto& test) {
  return test.param.function + (test.param.reference.second ? "_second" : "");
});

}  // namespace
