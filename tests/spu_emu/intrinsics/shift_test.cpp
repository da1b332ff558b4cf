#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

// Counts are taken modulo twice the lane's bits, negated where the name says rotate-and-mask.
template <int Width, u64 (*Shift)(u64, u64)>
u64 shift_by(u64 value, u64 count) {
  return Shift(value, count % (16 * Width));
}

template <int Width, u64 (*Shift)(u64, u64)>
u64 shift_by_negated(u64 value, u64 count) {
  return Shift(value, (0 - count) % (16 * Width));
}

TEST(ElementShift, ShiftsByCountsPerElementAndByOneCount) {
  for_types<vec_ushort8, vec_short8, vec_uint4, vec_int4>([](auto type) {
    using V = TYPE_OF(type);
    using C = spu_emu::detail::Unsigned<V>;
    constexpr int width = width_of<V>;
    const auto left = lanewise<width>(shift_by<width, shifted_left<width>>);
    const auto right = lanewise<width>(shift_by<width, shifted_right<width>>);
    const auto arithmetic = lanewise<width>(shift_by<width, shifted_right_signed<width>>);
    check<V, C>(
        "spu_sl", [](V a, C n) { return spu_sl(a, n); }, left);
    check<V, unsigned>(
        "spu_sl scalar", [](V a, unsigned n) { return spu_sl(a, n); }, with_splat<width>(left));
    check<V, C>(
        "spu_sr", [](V a, C n) { return spu_sr(a, n); }, right);
    check<V, unsigned>(
        "spu_sr scalar", [](V a, unsigned n) { return spu_sr(a, n); }, with_splat<width>(right));
    check<V, C>(
        "spu_sra", [](V a, C n) { return spu_sra(a, n); }, arithmetic);
    check<V, unsigned>(
        "spu_sra scalar", [](V a, unsigned n) { return spu_sra(a, n); }, with_splat<width>(arithmetic));
  });
}

TEST(ElementShift, ShiftsRightByNegatedCounts) {
  for_types<vec_ushort8, vec_short8, vec_uint4, vec_int4>([](auto type) {
    using V = TYPE_OF(type);
    using C = spu_emu::detail::Signed<V>;
    constexpr int width = width_of<V>;
    const auto right = lanewise<width>(shift_by_negated<width, shifted_right<width>>);
    const auto arithmetic = lanewise<width>(shift_by_negated<width, shifted_right_signed<width>>);
    check<V, C>(
        "spu_rlmask", [](V a, C n) { return spu_rlmask(a, n); }, right);
    check<V, int>(
        "spu_rlmask scalar", [](V a, int n) { return spu_rlmask(a, n); }, with_splat<width>(right));
    check<V, C>(
        "spu_rlmaska", [](V a, C n) { return spu_rlmaska(a, n); }, arithmetic);
    check<V, int>(
        "spu_rlmaska scalar", [](V a, int n) { return spu_rlmaska(a, n); }, with_splat<width>(arithmetic));
  });
}

TEST(ElementShift, RotatesLeft) {
  for_types<vec_ushort8, vec_short8>([](auto type) {
    using V = TYPE_OF(type);
    check<V, vec_short8>(
        "spu_rl", [](V a, vec_short8 n) { return spu_rl(a, n); }, lanewise<2>(rotated<2>));
    check<V, short>(
        "spu_rl scalar", [](V a, short n) { return spu_rl(a, n); }, with_splat<2>(lanewise<2>(rotated<2>)));
  });
  for_types<vec_uint4, vec_int4>([](auto type) {
    using V = TYPE_OF(type);
    check<V, vec_int4>(
        "spu_rl", [](V a, vec_int4 n) { return spu_rl(a, n); }, lanewise<4>(rotated<4>));
    check<V, int>(
        "spu_rl scalar", [](V a, int n) { return spu_rl(a, n); }, with_splat<4>(lanewise<4>(rotated<4>)));
  });
}

}  // namespace
