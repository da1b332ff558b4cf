// The largest error of a function over samples of all its arguments.
#pragma once

#include <functional>
#include <string>

#include "simdmath/evaluator.h"
#include "simdmath/references.h"

namespace simdmath_test {

using Evaluate = std::function<std::vector<Result>(unsigned function, const std::vector<Call>& calls)>;

struct Accuracy {
  double error = 0;
  std::string worst;  ///< its arguments and result
  std::size_t samples = 0;
};

/// `function` is the name with its ending. `density` multiplies the number of samples of every exponent.
Accuracy measure(const Reference& reference, const std::string& function, const Format& format,
                 const Evaluate& evaluate, int density);

}  // namespace simdmath_test
