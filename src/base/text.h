/// @file
/// Puts a message together from words and numbers. Messages are seldom: they are compiled to be small.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <limits>
#include <string>
#include <string_view>

namespace cellsweep {

[[gnu::cold]] inline void append_text(std::string& to, std::string_view words) {
  to += words;
}
[[gnu::cold]] inline void append_text(std::string& to, char letter) {
  to += letter;
}

/// In full.
[[gnu::cold]] void append_text(std::string& to, std::integral auto number) {
  std::array<char, 24> digits;
  to.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

/// With as many digits as tell floats apart.
[[gnu::cold]] void append_text(std::string& to, std::floating_point auto number) {
  constexpr int kDigits = std::numeric_limits<float>::max_digits10;
  std::array<char, 64> digits;
  char* const end = digits.data() + digits.size();
  to.append(digits.data(),
            std::to_chars(digits.data(), end, number, std::chars_format::general, kDigits).ptr);
}

/// All parts, one after the other.
template <class... Parts>
[[gnu::cold]] std::string text(const Parts&... parts) {
  std::string words;
  (append_text(words, parts), ...);
  return words;
}

}  // namespace cellsweep
