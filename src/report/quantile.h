/// @file
/// Order statistics of a list of times.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace cellsweep::report {

/// The smallest value that a share `q` (0 to 1) of the values does not exceed; 0 for an empty list. Always
/// one of the values: the lower median for q = 0.5 and an even count.
inline double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(values.size())));
  const std::size_t index = rank == 0 ? 0 : rank - 1;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index), values.end());
  return values[index];
}

}  // namespace cellsweep::report
