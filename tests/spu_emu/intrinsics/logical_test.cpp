#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

template <typename V, typename I, typename F>
void check_bitwise(const char* name, I intrinsic, F f) {
  check<V, V>(name, intrinsic, lanewise<8>(f));
}

TEST(Logic, CombinesBitsOfVectorsOfEveryType) {
  for_all_types([](auto type) {
    using V = TYPE_OF(type);
    check_bitwise<V>(
        "spu_and", [](V a, V b) { return spu_and(a, b); }, [](u64 a, u64 b) { return a & b; });
    check_bitwise<V>(
        "spu_or", [](V a, V b) { return spu_or(a, b); }, [](u64 a, u64 b) { return a | b; });
    check_bitwise<V>(
        "spu_xor", [](V a, V b) { return spu_xor(a, b); }, [](u64 a, u64 b) { return a ^ b; });
    check_bitwise<V>(
        "spu_andc", [](V a, V b) { return spu_andc(a, b); }, [](u64 a, u64 b) { return a & ~b; });
    check_bitwise<V>(
        "spu_eqv", [](V a, V b) { return spu_eqv(a, b); }, [](u64 a, u64 b) { return ~(a ^ b); });
    check_bitwise<V>(
        "spu_nand", [](V a, V b) { return spu_nand(a, b); }, [](u64 a, u64 b) { return ~(a & b); });
    check_bitwise<V>(
        "spu_nor", [](V a, V b) { return spu_nor(a, b); }, [](u64 a, u64 b) { return ~(a | b); });
    check_bitwise<V>(
        "spu_orc", [](V a, V b) { return spu_orc(a, b); }, [](u64 a, u64 b) { return a | ~b; });
  });
}

TEST(Logic, CombinesEveryElementWithAScalar) {
  for_integer_types([](auto type) {
    using V = TYPE_OF(type);
    using E = ElementOf<V>;
    constexpr int width = width_of<V>;
    check<V, E>(
        "spu_and", [](V a, E b) { return spu_and(a, b); },
        with_splat<width>(lanewise<width>([](u64 a, u64 b) { return a & b; })));
    check<V, E>(
        "spu_or", [](V a, E b) { return spu_or(a, b); },
        with_splat<width>(lanewise<width>([](u64 a, u64 b) { return a | b; })));
    check<V, E>(
        "spu_xor", [](V a, E b) { return spu_xor(a, b); },
        with_splat<width>(lanewise<width>([](u64 a, u64 b) { return a ^ b; })));
  });
}

TEST(Logic, SelectsBitByBit) {
  for_all_types([](auto type) {
    using V = TYPE_OF(type);
    using M = spu_emu::detail::Unsigned<V>;
    check<V, V, M>(
        "spu_sel", [](V a, V b, M m) { return spu_sel(a, b, m); },
        lanewise<8>([](u64 a, u64 b, u64 m) { return (a & ~m) | (b & m); }));
  });
}

TEST(Logic, OrsAllWordsIntoTheFirst) {
  for_types<vec_uint4, vec_int4>([](auto type) {
    using V = TYPE_OF(type);
    check<V>(
        "spu_orx", [](V a) { return spu_orx(a); },
        [](const Register& a) {
          Register r{};
          put<4>(r, 0, lane<4>(a, 0) | lane<4>(a, 1) | lane<4>(a, 2) | lane<4>(a, 3));
          return r;
        });
  });
}

}  // namespace
