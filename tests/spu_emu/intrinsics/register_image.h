// The tests' own picture of an SPU register: sixteen bytes, leftmost first, and its lanes as big-endian
// numbers.
#pragma once

#include <spu_intrinsics.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace reference {

using Register = std::array<std::uint8_t, 16>;

template <int Width>
constexpr int lanes = 16 / Width;

template <int Width>
std::uint64_t lane(const Register& r, int i) {
  std::uint64_t value = 0;
  for (int k = 0; k < Width; ++k) value = value << 8 | r[static_cast<std::size_t>(i * Width + k)];
  return value;
}

template <int Width>
std::int64_t signed_lane(const Register& r, int i) {
  const int unused = 64 - 8 * Width;
  return static_cast<std::int64_t>(lane<Width>(r, i) << unused) >> unused;
}

template <int Width>
void put(Register& r, int i, std::uint64_t value) {
  for (int k = Width - 1; k >= 0; --k, value >>= 8)
    r[static_cast<std::size_t>(i * Width + k)] = static_cast<std::uint8_t>(value);
}

// A register whose lanes are f(0), f(1), ...
template <int Width, typename F>
Register build(F f) {
  Register r{};
  for (int i = 0; i < lanes<Width>; ++i) put<Width>(r, i, static_cast<std::uint64_t>(f(i)));
  return r;
}

inline std::string text(const Register& r) {
  static const char digits[] = "0123456789abcdef";
  std::string s;
  for (std::size_t k = 0; k < 16; ++k) {
    if (k != 0 && k % 4 == 0) s += ' ';
    s += digits[r[k] >> 4];
    s += digits[r[k] & 15];
  }
  return s;
}

// Vectors and scalars to images and back, by element numbers and values only.
template <typename V>
Register image(const V& v) {
  constexpr int width = static_cast<int>(sizeof(v[0]));
  Register r{};
  for (int i = 0; i < lanes<width>; ++i) {
    const auto element = v[i];
    std::uint64_t b = 0;
    std::memcpy(&b, &element, sizeof element);
    put<width>(r, i, b);
  }
  return r;
}

inline Register image(const qword& q) {
  return image((vec_uint4)q);
}

template <typename V>
V vector(const Register& r) {
  if constexpr (std::is_same_v<V, qword>) {
    return (qword)vector<vec_uint4>(r);
  } else {
    V v{};
    using E = std::remove_cv_t<std::remove_reference_t<decltype(v[0])>>;
    for (int i = 0; i < lanes<sizeof(E)>; ++i) {
      const std::uint64_t b = lane<sizeof(E)>(r, i);
      E element;
      std::memcpy(&element, &b, sizeof element);
      v[i] = element;
    }
    return v;
  }
}

}  // namespace reference
