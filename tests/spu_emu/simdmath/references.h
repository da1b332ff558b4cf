// What the functions of the SIMD math library are, by MPFR.
#pragma once

#include <string>
#include <vector>

#include "simdmath/number.h"

namespace simdmath_test {

/// A function of one to three numbers.
struct Reference {
  std::string name;
  int arguments;
  void (*exact)(Number& result, const Number& x, const Number& y, const Number& z);
  /// Of two results the second.
  bool second = false;
  /// Of doubles: what an error is measured by where that is larger than the result. None where not set.
  void (*size)(Number& result, const Number& x) = nullptr;
};

/// For names with the ending f4 or d2.
const std::vector<Reference>& references();

}  // namespace simdmath_test
