#include <vmx2spu.h>

#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

template <int Width, u64 (*Shift)(u64, u64)>
u64 in_lane(u64 value, u64 count) {
  return Shift(value, count % (8 * Width));
}

TEST(VmxShift, TakesCountsModuloTheElementsBits) {
  for_integer_types([](auto type) {
    using V = TYPE_OF(type);
    using C = spu_emu::detail::Unsigned<V>;
    constexpr int width = width_of<V>;
    check<V, C>(
        "vec_sl", [](V a, C n) { return vec_sl(a, n); },
        lanewise<width>(in_lane<width, shifted_left<width>>));
    check<V, C>(
        "vec_sr", [](V a, C n) { return vec_sr(a, n); },
        lanewise<width>(in_lane<width, shifted_right<width>>));
    check<V, C>(
        "vec_sra", [](V a, C n) { return vec_sra(a, n); },
        lanewise<width>(in_lane<width, shifted_right_signed<width>>));
    check<V, C>(
        "vec_rl", [](V a, C n) { return vec_rl(a, n); }, lanewise<width>(rotated<width>));
  });
}

// Counts of whole-vector shifts are repeated in every byte, as AltiVec wants them.
TEST(VmxShift, ShiftsWholeVectorsByBitsAndBytes) {
  using C = vec_uchar16;
  for_types<vec_uchar16, vec_short8, vec_uint4, vec_float4>([](auto type) {
    using V = TYPE_OF(type);
    using B = unsigned char;
    check<V, B>(
        "vec_sll", [](V a, B n) { return vec_sll(a, (C)spu_splats(n)); },
        [](const Register& a, B n) { return moved_left(a, n & 7); });
    check<V, B>(
        "vec_srl", [](V a, B n) { return vec_srl(a, (C)spu_splats(n)); },
        [](const Register& a, B n) { return moved_left(a, -(n & 7)); });
    check<V, B>(
        "vec_slo", [](V a, B n) { return vec_slo(a, (C)spu_splats(n)); },
        [](const Register& a, B n) { return moved_left(a, n & 0x78); });
    check<V, B>(
        "vec_sro", [](V a, B n) { return vec_sro(a, (C)spu_splats(n)); },
        [](const Register& a, B n) { return moved_left(a, -(n & 0x78)); });
  });
}

TEST(VmxShift, PermutesByFiveBitSelectorsAndJoinsVectors) {
  for_types<vec_uchar16, vec_char16, vec_ushort8, vec_short8, vec_uint4, vec_int4, vec_float4>([](auto type) {
    using V = TYPE_OF(type);
    check<V, V, vec_uchar16>(
        "vec_perm", [](V a, V b, vec_uchar16 p) { return vec_perm(a, b, p); },
        [](const Register& a, const Register& b, const Register& p) {
          return shuffled(a, b, lanewise<1>([](u64 x) { return x & 31; })(p));
        });
    check<V, V, unsigned>(
        "vec_sld", [](V a, V b, unsigned n) { return vec_sld(a, b, n & 15); },
        [](const Register& a, const Register& b, unsigned n) {
          return shuffled(a, b, build<1>([&](int i) { return i + static_cast<int>(n & 15); }));
        });
  });
}

}  // namespace
