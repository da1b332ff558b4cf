#include <vmx2spu.h>

#include "check.h"
#include "operations.h"

#include <algorithm>
#include <limits>

namespace {

using namespace reference;

template <typename V>
s64 value(const Register& r, int i) {
  constexpr int width = width_of<V>;
  return std::is_signed_v<ElementOf<V>> ? signed_lane<width>(r, i) : static_cast<s64>(lane<width>(r, i));
}

template <typename V>
s64 saturated(s64 v) {
  using Limits = std::numeric_limits<ElementOf<V>>;
  return std::min<s64>(std::max<s64>(v, Limits::min()), Limits::max());
}

// f on the values of the lanes as V has them.
template <typename V, typename F>
auto on_values(F f) {
  return [f](const Register& a, const auto&... more) {
    return build<width_of<V>>([&](int i) { return f(value<V>(a, i), value<V>(more, i)...); });
  };
}

// Also with either operand as the boolean vector that an SPU takes for unsigned.
template <typename V, typename I, typename R>
void check_mixed(const char* name, I intrinsic, R ref) {
  using B = spu_emu::detail::Unsigned<V>;
  check<V, V>(name, intrinsic, ref);
  if constexpr (std::is_signed_v<ElementOf<V>>) {
    check<B, V>(
        name, [=](B a, V b) -> V { return intrinsic(a, b); }, ref);
    check<V, B>(
        name, [=](V a, B b) -> V { return intrinsic(a, b); }, ref);
  }
}

TEST(VmxArithmetic, AddsAndSubtractsWrapping) {
  for_integer_types([](auto type) {
    using V = TYPE_OF(type);
    check_mixed<V>(
        "vec_add", [](auto a, auto b) { return vec_add(a, b); },
        on_values<V>([](s64 a, s64 b) { return a + b; }));
    check_mixed<V>(
        "vec_sub", [](auto a, auto b) { return vec_sub(a, b); },
        on_values<V>([](s64 a, s64 b) { return a - b; }));
  });
}

TEST(VmxArithmetic, AddsAndSubtractsSaturating) {
  for_integer_types([](auto type) {
    using V = TYPE_OF(type);
    check_mixed<V>(
        "vec_adds", [](auto a, auto b) { return vec_adds(a, b); },
        on_values<V>([](s64 a, s64 b) { return saturated<V>(a + b); }));
    check_mixed<V>(
        "vec_subs", [](auto a, auto b) { return vec_subs(a, b); },
        on_values<V>([](s64 a, s64 b) { return saturated<V>(a - b); }));
  });
}

TEST(VmxArithmetic, TakesTheSmallerAndTheLarger) {
  for_integer_types([](auto type) {
    using V = TYPE_OF(type);
    check_mixed<V>(
        "vec_min", [](auto a, auto b) { return vec_min(a, b); },
        on_values<V>([](s64 a, s64 b) { return std::min(a, b); }));
    check_mixed<V>(
        "vec_max", [](auto a, auto b) { return vec_max(a, b); },
        on_values<V>([](s64 a, s64 b) { return std::max(a, b); }));
  });
}

TEST(VmxArithmetic, AveragesAndMakesAbsolute) {
  for_integer_types([](auto type) {
    using V = TYPE_OF(type);
    check<V, V>(
        "vec_avg", [](V a, V b) { return vec_avg(a, b); },
        on_values<V>([](s64 a, s64 b) { return (a + b + 1) >> 1; }));
  });
  for_types<vec_char16, vec_short8, vec_int4>([](auto type) {
    using V = TYPE_OF(type);
    check<V>(
        "vec_abs", [](V a) { return vec_abs(a); }, on_values<V>([](s64 a) { return a < 0 ? -a : a; }));
    check<V>(
        "vec_abss", [](V a) { return vec_abss(a); },
        on_values<V>([](s64 a) { return saturated<V>(a < 0 ? -a : a); }));
  });
}

TEST(VmxArithmetic, HasCarriesBorrowsAndSplats) {
  check<vec_uint4, vec_uint4>(
      "vec_addc", [](auto a, auto b) { return vec_addc(a, b); },
      lanewise<4>([](u64 a, u64 b) { return (a + b) >> 32; }));
  check<vec_uint4, vec_uint4>(
      "vec_subc", [](auto a, auto b) { return vec_subc(a, b); },
      lanewise<4>([](u64 a, u64 b) { return a >= b ? 1 : 0; }));
  EXPECT_EQ(image(vec_splat(vec_int4{1, 2, 3, 4}, 2)), image(vec_int4{3, 3, 3, 3}));
  EXPECT_EQ(image(vec_splat_s8(-3)), image(spu_splats(static_cast<signed char>(-3))));
  EXPECT_EQ(image(vec_splat_s16(-3)), image(spu_splats(static_cast<short>(-3))));
  EXPECT_EQ(image(vec_splat_s32(-3)), image(spu_splats(-3)));
  EXPECT_EQ(image(vec_splat_u8(3)), image(spu_splats(static_cast<unsigned char>(3))));
  EXPECT_EQ(image(vec_splat_u16(3)), image(spu_splats(static_cast<unsigned short>(3))));
  EXPECT_EQ(image(vec_splat_u32(3)), image(spu_splats(3U)));
  EXPECT_EQ(image(vec_splats(2.5f)), image(spu_splats(2.5f)));
  EXPECT_EQ(vec_extract(vec_promote(7, 2), 2), 7);
  EXPECT_EQ(image(vec_insert(9, vec_int4{1, 2, 3, 4}, 1)), image(vec_int4{1, 9, 3, 4}));
}

}  // namespace
