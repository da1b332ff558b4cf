/// @file
/// Roots and powers from + − × ÷ √ alone: libm's own differ between machines, these give the same bits (W4).
#pragma once

#include <cfloat>
#include <cmath>

namespace cellsweep {

static_assert(FLT_EVAL_METHOD == 0,
              "scenes have the same bits only where arithmetic keeps its type's precision");

/// The cube root of x, 1 <= x < 1e100, to a few units in the last place.
inline double cube_root(double x) {
  double root = 1;
  while (root * root * root < x) root *= 2;
  // From at most twice the root, Newton's errors are 0.42, 0.11, 0.011, 1e-4, 1e-8, 2e-16.
  constexpr int kSteps = 8;
  for (int step = 0; step < kSteps; ++step) root = (2 * root + x / (root * root)) / 3;
  return root;
}

/// base^exponent for base >= 1 and 0 <= exponent < 1, with the exponent cut to 32 binary digits: each digit
/// that is set contributes the square root of the root before.
inline double power(double base, double exponent) {
  constexpr int kDigits = 32;
  double result = 1;
  double root = base;
  for (int digit = 0; digit < kDigits; ++digit) {
    root = std::sqrt(root);
    exponent *= 2;
    if (exponent >= 1) {
      exponent -= 1;
      result *= root;
    }
  }
  return result;
}

}  // namespace cellsweep
