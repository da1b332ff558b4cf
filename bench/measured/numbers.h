/// @file
/// Measured numbers, as tables write them.
#pragma once

#include <string>

namespace cellsweep::bench {

/// Two digits that count: "0.87", "1.3", "24", "130", "1,300". Zero is "0.00".
std::string two_digits(double number);

/// With so many digits behind the point.
std::string decimals_text(double number, int decimals);

}  // namespace cellsweep::bench
