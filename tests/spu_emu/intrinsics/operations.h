// Scalar references that several intrinsics share, each on register images and a lane width.
#pragma once

#include "register_image.h"

namespace reference {

using u64 = std::uint64_t;
using s64 = std::int64_t;

// f on each pair (or triple) of lanes, unsigned or sign-extended.
template <int Width, typename F>
auto lanewise(F f) {
  return [f](const Register& a, const auto&... more) {
    return build<Width>([&](int i) { return f(lane<Width>(a, i), lane<Width>(more, i)...); });
  };
}

template <int Width, typename F>
auto signed_lanewise(F f) {
  return [f](const Register& a, const auto&... more) {
    return build<Width>([&](int i) { return f(signed_lane<Width>(a, i), signed_lane<Width>(more, i)...); });
  };
}

// A reference for (vector, scalar) from one for (vector, vector).
template <int Width, typename F>
auto with_splat(F f) {
  return [f](const Register& a, auto scalar) {
    return f(a, build<Width>([&](int) { return static_cast<u64>(scalar); }));
  };
}

template <int Width>
u64 shifted_left(u64 value, u64 count) {
  return count >= 8 * Width ? 0 : value << count;
}

template <int Width>
u64 shifted_right(u64 value, u64 count) {
  return count >= 8 * Width ? 0 : value >> count;
}

template <int Width>
u64 shifted_right_signed(u64 value, u64 count) {
  const s64 extended = static_cast<s64>(value << (64 - 8 * Width)) >> (64 - 8 * Width);
  return static_cast<u64>(extended >> (count > 63 ? 63 : count));
}

template <int Width>
u64 rotated(u64 value, u64 count) {
  const u64 n = count % (8 * Width);
  return n == 0 ? value : value << n | value >> (8 * Width - n);
}

// Bit k of a register, bit 0 being the leftmost.
inline bool bit_of(const Register& r, int k) {
  return (r[static_cast<std::size_t>(k / 8)] >> (7 - k % 8) & 1) != 0;
}

// The register whose bit k is from(k); bits from outside 0 to 127 are zero.
template <typename F>
Register bits_from(const Register& r, F from) {
  Register result{};
  for (int k = 0; k < 128; ++k) {
    const int source = from(k);
    if (source >= 0 && source < 128 && bit_of(r, source))
      result[static_cast<std::size_t>(k / 8)] |= static_cast<std::uint8_t>(0x80 >> k % 8);
  }
  return result;
}

inline Register moved_left(const Register& r, int bits) {
  return bits_from(r, [&](int k) { return k + bits; });
}

inline Register moved_around(const Register& r, int bits) {
  return bits_from(r, [&](int k) { return (k + bits) % 128; });
}

inline Register shuffled(const Register& a, const Register& b, const Register& pattern) {
  Register r{};
  for (std::size_t k = 0; k < 16; ++k) {
    const unsigned p = pattern[k];
    if (p < 0x80)
      r[k] = (p & 16) != 0 ? b[p & 15] : a[p & 15];
    else
      r[k] = p < 0xc0 ? 0x00 : p < 0xe0 ? 0xff : 0x80;
  }
  return r;
}

inline u64 leading_zeros32(u64 word) {
  u64 n = 0;
  while (n < 32 && (word >> (31 - n) & 1) == 0) ++n;
  return n;
}

inline u64 ones_in(u64 value) {
  u64 n = 0;
  for (; value != 0; value >>= 1) n += value & 1;
  return n;
}

// The last bits of all lanes, the first lane's leftmost, in word 0.
template <int Width>
Register gathered(const Register& a) {
  u64 collected = 0;
  for (int i = 0; i < lanes<Width>; ++i) collected = collected << 1 | (lane<Width>(a, i) & 1);
  Register r{};
  put<4>(r, 0, collected);
  return r;
}

template <int Width>
Register mask_of(u64 bits) {
  return build<Width>([&](int i) { return (bits >> (lanes<Width> - 1 - i) & 1) != 0 ? ~u64{0} : 0; });
}

// Products of halfword i of each operand's words; 0 is the left one.
template <typename F>
auto halfword_products(int half_a, int half_b, F finish) {
  return [=](const Register& a, const Register& b, const auto&... c) {
    return build<4>([&](int i) {
      return finish(signed_lane<2>(a, 2 * i + half_a) * signed_lane<2>(b, 2 * i + half_b),
                    signed_lane<4>(c, i)...);
    });
  };
}

template <typename F>
auto unsigned_halfword_products(int half_a, int half_b, F finish) {
  return [=](const Register& a, const Register& b, const auto&... c) {
    return build<4>([&](int i) {
      return finish(lane<2>(a, 2 * i + half_a) * lane<2>(b, 2 * i + half_b), lane<4>(c, i)...);
    });
  };
}

constexpr u64 all_ones(bool condition) {
  return condition ? ~u64{0} : 0;
}

}  // namespace reference
