/// @file
/// Puts a message together from words and numbers.
#pragma once

#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace cellsweep {

/// All parts, one after the other; floats with as many digits as tell them apart.
template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(std::numeric_limits<float>::max_digits10);
  (stream << ... << parts);
  return stream.str();
}

}  // namespace cellsweep
