// Uses of C++17 and its library that need no exceptions; exits with 0 if they compute what they should.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

inline constexpr std::array<std::uint32_t, 4> kNumbers = {3, 1, 2, 4};

template <class... Numbers>
constexpr auto sum(Numbers... numbers) {
  return (numbers + ... + 0U);
}

template <class T>
std::optional<T> half(T number) {
  if constexpr (std::is_integral_v<T>) {
    if (number % 2 != 0) return std::nullopt;
  }
  return number / 2;
}

int main() {
  auto sorted = kNumbers;
  std::sort(sorted.begin(), sorted.end());
  const auto [first, last] = std::pair(sorted.front(), sorted.back());
  static_assert(sum(1U, 2U, 3U) == 6);
  return first == 1 && half(last) == 2U && !half(first) ? 0 : 1;
}
