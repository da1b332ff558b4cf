/// @file
/// Puts a message together from words and numbers.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <limits>
#include <string>
#include <string_view>

namespace cellsweep {

inline void append_text(std::string& to, std::string_view words) {
  to += words;
}
inline void append_text(std::string& to, char letter) {
  to += letter;
}

/// Whole numbers in full, floats with as many digits as tell them apart.
template <class Number>
requires(std::integral<Number> || std::floating_point<Number>) void append_text(std::string& to,
                                                                                Number number) {
  std::array<char, 64> digits;
  char* const end = digits.data() + digits.size();
  if constexpr (std::integral<Number>) {
    to.append(digits.data(), std::to_chars(digits.data(), end, number).ptr);
  } else {
    constexpr int kDigits = std::numeric_limits<float>::max_digits10;
    to.append(digits.data(),
              std::to_chars(digits.data(), end, number, std::chars_format::general, kDigits).ptr);
  }
}

/// All parts, one after the other.
template <class... Parts>
std::string text(const Parts&... parts) {
  std::string words;
  (append_text(words, parts), ...);
  return words;
}

}  // namespace cellsweep
