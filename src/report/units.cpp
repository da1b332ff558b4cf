#include "report/units.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace cellsweep::report {
namespace {

// Where rounding to three digits would write one more before the point, there is one less behind it.
std::string three_digits(double value) {
  const double size = std::fabs(value);
  const int digits = size >= 99.95 ? 0 : size >= 9.995 ? 1 : size >= 0.9995 || size == 0 ? 2 : 3;
  std::array<char, 48> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", digits, value);
  return buffer.data();
}

}  // namespace

std::string time_text(double microseconds) {
  const double size = std::fabs(microseconds);
  if (size >= 999'500) return three_digits(microseconds / 1e6) + " s";
  if (size >= 999.5) return three_digits(microseconds / 1e3) + " ms";
  return three_digits(microseconds) + " µs";
}

std::string count_text(std::size_t count) {
  const std::string digits = std::to_string(count);
  std::string result;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) result += ',';
    result += digits[i];
  }
  return result;
}

std::string factor_text(double factor) {
  return three_digits(factor);
}

}  // namespace cellsweep::report
