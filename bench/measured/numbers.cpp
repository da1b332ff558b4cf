#include "bench/measured/numbers.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include "report/units.h"

namespace cellsweep::bench {

std::string two_digits(double number) {
  if (number < 0.995) return decimals_text(number, 2);
  if (number < 9.95) return decimals_text(number, 1);
  double unit = 1;
  while (number / unit >= 99.5) unit *= 10;
  return report::count_text(static_cast<std::size_t>(std::llround(number / unit) * std::llround(unit)));
}

std::string decimals_text(double number, int decimals) {
  std::array<char, 64> digits{};
  std::snprintf(digits.data(), digits.size(), "%.*f", decimals, number);
  return digits.data();
}

}  // namespace cellsweep::bench
