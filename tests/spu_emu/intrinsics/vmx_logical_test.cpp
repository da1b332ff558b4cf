#include <vmx2spu.h>

#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

// Each operation on two vectors of a type, and with a boolean vector on either side where the SDK mixes them.
template <typename V, typename I, typename F>
void check_bits(const char* name, I intrinsic, F f) {
  using B = spu_emu::detail::Unsigned<V>;
  check<V, V>(name, intrinsic, lanewise<8>(f));
  if constexpr (!std::is_same_v<V, B>) {
    check<B, V>(
        name, [=](B a, V b) -> V { return intrinsic(a, b); }, lanewise<8>(f));
    check<V, B>(
        name, [=](V a, B b) -> V { return intrinsic(a, b); }, lanewise<8>(f));
  }
}

TEST(VmxLogic, CombinesBitsAlsoOfBooleanVectors) {
  for_types<vec_uchar16, vec_char16, vec_ushort8, vec_short8, vec_uint4, vec_int4, vec_float4>([](auto type) {
    using V = TYPE_OF(type);
    check_bits<V>(
        "vec_and", [](auto a, auto b) { return vec_and(a, b); }, [](u64 a, u64 b) { return a & b; });
    check_bits<V>(
        "vec_or", [](auto a, auto b) { return vec_or(a, b); }, [](u64 a, u64 b) { return a | b; });
    check_bits<V>(
        "vec_xor", [](auto a, auto b) { return vec_xor(a, b); }, [](u64 a, u64 b) { return a ^ b; });
    check_bits<V>(
        "vec_andc", [](auto a, auto b) { return vec_andc(a, b); }, [](u64 a, u64 b) { return a & ~b; });
    using M = spu_emu::detail::Unsigned<V>;
    check<V, V>(
        "vec_nor", [](V a, V b) { return vec_nor(a, b); },
        lanewise<8>([](u64 a, u64 b) { return ~(a | b); }));
    check<V, V, M>(
        "vec_sel", [](V a, V b, M m) { return vec_sel(a, b, m); },
        lanewise<8>([](u64 a, u64 b, u64 m) { return (a & ~m) | (b & m); }));
  });
}

}  // namespace
