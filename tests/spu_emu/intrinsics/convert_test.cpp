#include "check.h"
#include "exact.h"
#include "operations.h"

namespace {

using namespace reference;

TEST(Extend, SignExtendsTheRightHalfOfEachWiderElement) {
  check<vec_char16>(
      "spu_extend", [](vec_char16 v) { return spu_extend(v); },
      [](const Register& a) { return build<2>([&](int i) { return signed_lane<1>(a, 2 * i + 1); }); });
  check<vec_short8>(
      "spu_extend", [](vec_short8 v) { return spu_extend(v); },
      [](const Register& a) { return build<4>([&](int i) { return signed_lane<2>(a, 2 * i + 1); }); });
  check<vec_int4>(
      "spu_extend", [](vec_int4 v) { return spu_extend(v); },
      [](const Register& a) { return build<8>([&](int i) { return signed_lane<4>(a, 2 * i + 1); }); });
}

// IEEE single to double; denormals become zeros, NaN the default one.
u64 widened(u64 word) {
  const u64 sign = word >> 31 << 63;
  const u64 exponent = word >> 23 & 255;
  const u64 fraction = word & 0x7fffff;
  if (exponent == 255) return fraction != 0 ? default_nan : sign | 0x7ff0000000000000;
  if (exponent == 0) return sign;
  return sign | (exponent + 896) << 52 | fraction << 29;
}

TEST(Extend, WidensEvenFloatsToDoubles) {
  check<vec_float4>(
      "spu_extend", [](vec_float4 v) { return spu_extend(v); },
      [](const Register& a) { return build<8>([&](int i) { return widened(lane<4>(a, 2 * i)); }); });
}

u64 narrowed(u64 b, Rounding mode) {
  const u64 sign = b >> 63 << 31;
  const u64 exponent = b >> 52 & 0x7ff;
  if (is_nan(b)) return 0x7fc00000;
  if (exponent == 0x7ff) return sign | 0x7f800000;
  if (exponent == 0) return sign;
  ExactSum sum;
  sum.add({sign != 0, (b & 0xfffffffffffff) | 1ULL << 52, static_cast<int>(exponent) - 1075});
  const Term t = sum.rounded(24, -149, mode);
  if (t.mantissa < 1 << 23) return sign | t.mantissa;
  const u64 result = (static_cast<u64>(t.exponent + 149) << 23) + t.mantissa;
  if (result < 0x7f800000) return sign | result;
  const bool to_infinity = mode == Rounding::nearest || mode == (t.negative ? Rounding::down : Rounding::up);
  return sign | (to_infinity ? 0x7f800000 : 0x7f7fffff);
}

TEST(Round, NarrowsDoublesToEvenFloatsByTheFpscr) {
  constexpr Rounding modes[] = {Rounding::nearest, Rounding::toward_zero, Rounding::up, Rounding::down};
  for (unsigned int first = 0; first < 4; ++first) {
    for (unsigned int second = 0; second < 4; ++second) {
      spu_mtfpscr(vec_uint4{first << 10 | second << 8, 0, 0, 0});
      check<vec_double2>(
          "spu_roundtf", [](vec_double2 v) { return spu_roundtf(v); },
          [&](const Register& a) {
            Register r{};
            put<4>(r, 0, narrowed(lane<8>(a, 0), modes[first]));
            put<4>(r, 2, narrowed(lane<8>(a, 1), modes[second]));
            return r;
          });
    }
  }
  spu_mtfpscr(vec_uint4{});
}

u64 scaled_float(s64 integer, int scale) {
  ExactSum sum;
  sum.add({integer < 0, static_cast<u64>(integer < 0 ? -integer : integer), -scale});
  return spu_float_from(sum);
}

TEST(Convert, MakesFloatsOfScaledIntegersTruncating) {
  const spu_emu::SpuFloatMode mode;
  check<vec_int4, unsigned>(
      "spu_convtf", [](vec_int4 v, unsigned n) { return spu_convtf(v, n); },
      [](const Register& a, unsigned n) {
        return build<4>([&](int i) { return scaled_float(signed_lane<4>(a, i), n & 127); });
      });
  check<vec_uint4, unsigned>(
      "spu_convtf", [](vec_uint4 v, unsigned n) { return spu_convtf(v, n); },
      [](const Register& a, unsigned n) {
        return build<4>([&](int i) { return scaled_float(static_cast<s64>(lane<4>(a, i)), n & 127); });
      });
}

// The float times 2^scale as an integer, truncated and held between the limits.
u64 scaled_integer(u64 word, int scale, s64 least, s64 largest) {
  const Term t = spu_float_term(static_cast<std::uint32_t>(word));
  const int exponent = t.exponent + scale;
  if (t.mantissa == 0 || exponent < -24) return 0;
  if (exponent > 16) return static_cast<u64>(t.negative ? least : largest);
  const s64 size = static_cast<s64>(exponent >= 0 ? t.mantissa << exponent : t.mantissa >> -exponent);
  const s64 value = t.negative ? -size : size;
  return static_cast<u64>(value < least ? least : value > largest ? largest : value);
}

TEST(Convert, MakesScaledIntegersOfFloatsSaturating) {
  const spu_emu::SpuFloatMode mode;
  check<vec_float4, int>(
      "spu_convts", [](vec_float4 v, int n) { return spu_convts(v, n); },
      [](const Register& a, int n) {
        return build<4>([&](int i) { return scaled_integer(lane<4>(a, i), n & 127, INT32_MIN, INT32_MAX); });
      });
  check<vec_float4, int>(
      "spu_convtu", [](vec_float4 v, int n) { return spu_convtu(v, n); },
      [](const Register& a, int n) {
        return build<4>([&](int i) { return scaled_integer(lane<4>(a, i), n & 127, 0, UINT32_MAX); });
      });
}

}  // namespace
