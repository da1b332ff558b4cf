/// @file
/// Numbers with their units, as a person reads them.
#pragma once

#include <cstddef>
#include <string>

namespace cellsweep::report {

/// A time with three digits and its unit: "27.1 ms", "513 µs", "0.215 µs".
std::string time_text(double microseconds);

/// The same for a time in milliseconds.
inline std::string duration_text(double milliseconds) {
  return time_text(1000 * milliseconds);
}

/// A whole number with commas: "1,024".
std::string count_text(std::size_t count);

/// A factor with three digits: "12.7".
std::string factor_text(double factor);

}  // namespace cellsweep::report
