/// @file
/// Floats on either side of a number in double.
#pragma once

#include <cfloat>
#include <cmath>

namespace cellsweep::queries {

/// Finite and not above the number, even where that is off by a few roundings; one below all floats becomes
/// the lowest.
inline float below(double number) {
  const double lower = number - std::fabs(number) * 0x1p-22 - FLT_MIN;
  return lower > -FLT_MAX ? static_cast<float>(lower) : -FLT_MAX;
}

/// Finite and not below the number, in the same way.
inline float above(double number) {
  const double upper = number + std::fabs(number) * 0x1p-22 + FLT_MIN;
  return upper < FLT_MAX ? static_cast<float>(upper) : FLT_MAX;
}

}  // namespace cellsweep::queries
