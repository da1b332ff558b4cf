#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

TEST(IntegerArithmetic, AddsAndSubtractsModuloTheElementWidth) {
  for_types<vec_ushort8, vec_short8, vec_uint4, vec_int4>([](auto type) {
    using V = TYPE_OF(type);
    using E = ElementOf<V>;
    constexpr int width = width_of<V>;
    const auto sum = lanewise<width>([](u64 a, u64 b) { return a + b; });
    const auto difference = lanewise<width>([](u64 a, u64 b) { return a - b; });
    check<V, V>(
        "spu_add", [](V a, V b) { return spu_add(a, b); }, sum);
    check<V, E>(
        "spu_add scalar", [](V a, E b) { return spu_add(a, b); }, with_splat<width>(sum));
    check<V, V>(
        "spu_sub", [](V a, V b) { return spu_sub(a, b); }, difference);
    check<E, V>(
        "spu_sub scalar", [](E a, V b) { return spu_sub(a, b); },
        [&](E a, const Register& b) {
          return difference(build<width>([&](int) { return static_cast<u64>(a); }), b);
        });
  });
}

TEST(IntegerArithmetic, CarriesAndBorrowsChainWords) {
  for_types<vec_uint4, vec_int4>([](auto type) {
    using V = TYPE_OF(type);
    constexpr u64 mask = 0xffffffff;
    check<V, V, V>(
        "spu_addx", [](V a, V b, V c) { return spu_addx(a, b, c); },
        lanewise<4>([](u64 a, u64 b, u64 c) { return a + b + (c & 1); }));
    check<V, V, V>(
        "spu_subx", [](V a, V b, V c) { return spu_subx(a, b, c); },
        lanewise<4>([](u64 a, u64 b, u64 c) { return a - b - 1 + (c & 1); }));
    check<V, V>(
        "spu_genc", [](V a, V b) { return spu_genc(a, b); },
        lanewise<4>([](u64 a, u64 b) { return (a + b) >> 32; }));
    check<V, V, V>(
        "spu_gencx", [](V a, V b, V c) { return spu_gencx(a, b, c); },
        lanewise<4>([](u64 a, u64 b, u64 c) { return (a + b + (c & 1)) >> 32; }));
    check<V, V>(
        "spu_genb", [](V a, V b) { return spu_genb(a, b); },
        lanewise<4>([](u64 a, u64 b) { return a >= b ? 1 : 0; }));
    check<V, V, V>(
        "spu_genbx", [](V a, V b, V c) { return spu_genbx(a, b, c); },
        lanewise<4>([](u64 a, u64 b, u64 c) { return (a + (mask - b) + (c & 1)) >> 32; }));
  });
}

TEST(IntegerArithmetic, AveragesDifferencesAndSumsBytes) {
  using V = vec_uchar16;
  check<V, V>(
      "spu_avg", [](V a, V b) { return spu_avg(a, b); },
      lanewise<1>([](u64 a, u64 b) { return (a + b + 1) / 2; }));
  check<V, V>(
      "spu_absd", [](V a, V b) { return spu_absd(a, b); },
      lanewise<1>([](u64 a, u64 b) { return a > b ? a - b : b - a; }));
  check<V, V>(
      "spu_sumb", [](V a, V b) { return spu_sumb(a, b); },
      [](const Register& a, const Register& b) {
        return build<2>([&](int i) {
          const Register& from = i % 2 == 0 ? b : a;
          u64 sum = 0;
          for (int k = 0; k < 4; ++k) sum += lane<1>(from, i / 2 * 4 + k);
          return sum;
        });
      });
}

}  // namespace
