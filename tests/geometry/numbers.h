/// @file
/// The floats that are no ordinary numbers.
#pragma once

#include <limits>

namespace cellsweep {

inline constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

}  // namespace cellsweep
