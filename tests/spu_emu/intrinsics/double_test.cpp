#include "check.h"
#include "exact.h"
#include "operations.h"

namespace {

using namespace reference;

using V = vec_double2;

constexpr u64 sign = 0x8000000000000000;

// The result negated, but a NaN stays the default one.
u64 negated(u64 b) {
  return is_nan(b) ? b : b ^ sign;
}
u64 with_sign_flipped(u64 b) {
  return b ^ sign;
}

constexpr Rounding modes[] = {Rounding::nearest, Rounding::toward_zero, Rounding::up, Rounding::down};

// A reference whose two lanes round in two modes: f(mode, lanes...).
template <typename F>
auto in_modes(Rounding first, Rounding second, F f) {
  return [=](const Register& a, const auto&... more) {
    return build<8>([&](int i) { return f(i == 0 ? first : second, lane<8>(a, i), lane<8>(more, i)...); });
  };
}

void check_arithmetic(Rounding first, Rounding second) {
  check<V, V>(
      "spu_add", [](V a, V b) { return spu_add(a, b); },
      in_modes(first, second, [](Rounding m, u64 a, u64 b) { return spu_double_add(a, b, m); }));
  check<V, V>(
      "spu_sub", [](V a, V b) { return spu_sub(a, b); },
      in_modes(first, second, [](Rounding m, u64 a, u64 b) {
        return spu_double_add(a, is_nan(b) ? b : with_sign_flipped(b), m);
      }));
  check<V, V>(
      "spu_mul", [](V a, V b) { return spu_mul(a, b); },
      in_modes(first, second, [](Rounding m, u64 a, u64 b) { return spu_double_multiply(a, b, m); }));
}

void check_multiply_add(Rounding first, Rounding second) {
  check<V, V, V>(
      "spu_madd", [](V a, V b, V c) { return spu_madd(a, b, c); },
      in_modes(first, second, [](Rounding m, u64 a, u64 b, u64 c) { return spu_double_madd(a, b, c, m); }));
  check<V, V, V>(
      "spu_msub", [](V a, V b, V c) { return spu_msub(a, b, c); },
      in_modes(first, second, [](Rounding m, u64 a, u64 b, u64 c) {
        return spu_double_madd(a, b, with_sign_flipped(c), m);
      }));
  check<V, V, V>(
      "spu_nmadd", [](V a, V b, V c) { return spu_nmadd(a, b, c); },
      in_modes(first, second,
               [](Rounding m, u64 a, u64 b, u64 c) { return negated(spu_double_madd(a, b, c, m)); }));
  check<V, V, V>(
      "spu_nmsub", [](V a, V b, V c) { return spu_nmsub(a, b, c); },
      in_modes(first, second, [](Rounding m, u64 a, u64 b, u64 c) {
        return negated(spu_double_madd(a, b, with_sign_flipped(c), m));
      }));
}

TEST(Double, RoundsToNearestUnderTheSpusFloatMode) {
  const spu_emu::SpuFloatMode mode;
  check_arithmetic(Rounding::nearest, Rounding::nearest);
  check_multiply_add(Rounding::nearest, Rounding::nearest);
  EXPECT_EQ(_mm_getcsr() & 0xffc0, spu_emu::spu_mxcsr) << "the caller's mode must come back";
}

TEST(Double, RoundsEachSlotByTheFpscr) {
  const spu_emu::SpuFloatMode mode;
  for (unsigned int first = 1; first < 4; ++first) {
    const unsigned int second = (first + 1) % 4;
    spu_mtfpscr(vec_uint4{first << 10 | second << 8, 0, 0, 0});
    check_arithmetic(modes[first], modes[second]);
    check_multiply_add(modes[first], modes[second]);
  }
  spu_mtfpscr(vec_uint4{});
}

TEST(Double, HasAScalarMultiplyAdd) {
  const auto both = [](double d) { return vec_double2{d, d}; };
  check<V, V>(
      "dfmas", [&](V a, V b) { return both(dfmas(a[0], a[1], b[0])); },
      [](const Register& a, const Register& b) {
        const u64 sum = spu_double_madd(lane<8>(a, 0), lane<8>(a, 1), lane<8>(b, 0), Rounding::nearest);
        return build<8>([&](int) { return sum; });
      });
}

s64 key(u64 b) {
  const u64 size = b & ~sign;
  if (size < 0x0010000000000000) return 0;
  return b >> 63 != 0 ? -static_cast<s64>(size) : static_cast<s64>(size);
}

template <typename F>
auto comparison(F f) {
  return lanewise<8>([f](u64 a, u64 b) { return all_ones(!is_nan(a) && !is_nan(b) && f(a, b)); });
}

TEST(DoubleCompare, OrdersNumbersAndNoNan) {
  check<V, V>(
      "spu_cmpeq", [](V a, V b) { return spu_cmpeq(a, b); },
      comparison([](u64 a, u64 b) { return key(a) == key(b); }));
  check<V, V>(
      "spu_cmpgt", [](V a, V b) { return spu_cmpgt(a, b); },
      comparison([](u64 a, u64 b) { return key(a) > key(b); }));
  check<V, V>(
      "spu_cmpabseq", [](V a, V b) { return spu_cmpabseq(a, b); },
      comparison([](u64 a, u64 b) { return key(a & ~sign) == key(b & ~sign); }));
  check<V, V>(
      "spu_cmpabsgt", [](V a, V b) { return spu_cmpabsgt(a, b); },
      comparison([](u64 a, u64 b) { return key(a & ~sign) > key(b & ~sign); }));
}

u64 kind_of(u64 b) {
  const u64 size = b & ~sign;
  const u64 positive = b >> 63 != 0 ? 0 : 1;
  if (is_nan(b)) return SPU_SV_NAN;
  if (size == 0x7ff0000000000000) return u64{SPU_SV_NEG_INFINITY} << positive;
  if (size == 0) return u64{SPU_SV_NEG_ZERO} << positive;
  if (size < 0x0010000000000000) return u64{SPU_SV_NEG_DENORM} << positive;
  return 0;
}

TEST(DoubleCompare, TestsForSpecialValues) {
  check<V, int>(
      "spu_testsv", [](V a, int kinds) { return spu_testsv(a, kinds); },
      [](const Register& a, int kinds) {
        return build<8>(
            [&](int i) { return all_ones((kind_of(lane<8>(a, i)) & static_cast<u64>(kinds)) != 0); });
      });
}

}  // namespace
