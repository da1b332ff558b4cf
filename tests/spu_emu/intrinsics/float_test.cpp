// Built twice: as it is, for inputs and results in the ordinary range, and with SPU_EMU_PRECISE for all
// inputs.
#include "check.h"
#include "exact.h"
#include "operations.h"

namespace {

using namespace reference;

using V = vec_float4;

#ifdef SPU_EMU_PRECISE
#define FLOAT_SUITE PreciseFloat
#else
#define FLOAT_SUITE DefaultFloat
#endif

bool exponent_255(u64 word) {
  return (word >> 23 & 255) == 255;
}

// Default builds promise nothing for exponent 255 and may give -0.
template <int Arguments>
bool agree_as_promised(const Value& result, const Value& expected, const Value* arguments) {
#ifdef SPU_EMU_PRECISE
  static_cast<void>(arguments);
  return result == expected;
#else
  for (int i = 0; i < 4; ++i) {
    const u64 r = lane<4>(result.image, i);
    const u64 e = lane<4>(expected.image, i);
    bool promised = !exponent_255(e);
    for (int k = 0; k < Arguments; ++k) promised = promised && !exponent_255(lane<4>(arguments[k].image, i));
    if (promised && r != e && !(e == 0 && r == 0x80000000)) return false;
  }
  return true;
#endif
}

constexpr u64 sign = 0x80000000;
constexpr u64 one = 0x3f800000;

u64 madd(u64 a, u64 b, u64 c) {
  return spu_madd(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                  static_cast<std::uint32_t>(c));
}

class FLOAT_SUITE : public testing::Test {
 private:
  spu_emu::SpuFloatMode mode_;
};

TEST_F(FLOAT_SUITE, AddsSubtractsAndMultipliesTruncating) {
  check<V, V>(
      "spu_add", [](V a, V b) { return spu_add(a, b); },
      lanewise<4>([](u64 a, u64 b) { return madd(a, one, b); }), agree_as_promised<2>);
  check<V, V>(
      "spu_sub", [](V a, V b) { return spu_sub(a, b); },
      lanewise<4>([](u64 a, u64 b) { return madd(b, one | sign, a); }), agree_as_promised<2>);
  check<V, V>(
      "spu_mul", [](V a, V b) { return spu_mul(a, b); },
      lanewise<4>([](u64 a, u64 b) { return madd(a, b, 0); }), agree_as_promised<2>);
}

TEST_F(FLOAT_SUITE, MultipliesAndAddsWithOneRounding) {
  check<V, V, V>(
      "spu_madd", [](V a, V b, V c) { return spu_madd(a, b, c); }, lanewise<4>(madd), agree_as_promised<3>);
  check<V, V, V>(
      "spu_msub", [](V a, V b, V c) { return spu_msub(a, b, c); },
      lanewise<4>([](u64 a, u64 b, u64 c) { return madd(a, b, c ^ sign); }), agree_as_promised<3>);
  check<V, V, V>(
      "spu_nmsub", [](V a, V b, V c) { return spu_nmsub(a, b, c); },
      lanewise<4>([](u64 a, u64 b, u64 c) { return madd(a ^ sign, b, c); }), agree_as_promised<3>);
}

TEST_F(FLOAT_SUITE, HasAScalarMultiplyAdd) {
  const auto in_lanes = [](float f) { return spu_splats(f); };
  check<V>(
      "fmas", [&](V v) { return in_lanes(fmas(v[0], v[1], v[2])); },
      [](const Register& r) {
        const u64 sum = madd(lane<4>(r, 0), lane<4>(r, 1), lane<4>(r, 2));
        return build<4>([&](int) { return sum; });
      },
      [](const Value& result, const Value& expected, const Value* arguments) {
        bool promised = true;
        for (int i = 0; i < 3; ++i) promised = promised && !exponent_255(lane<4>(arguments->image, i));
        return !promised || agree_as_promised<0>(result, expected, arguments);
      });
}

// Sums close to cancelling, and addends of a half unit in the last place, both of which a second rounding
// spoils.
TEST_F(FLOAT_SUITE, RoundsOnceWhereProductAndAddendNearlyCancel) {
  check<V, V>(
      "spu_msub of a product rounded", [](V a, V b) { return spu_msub(a, b, spu_mul(a, b)); },
      lanewise<4>([](u64 a, u64 b) { return madd(a, b, madd(a, b, 0) ^ sign); }),
      [](const Value& result, const Value& expected, const Value* arguments) {
        for (int i = 0; i < 4; ++i) {
          const u64 product = madd(lane<4>(arguments[0].image, i), lane<4>(arguments[1].image, i), 0);
          if (exponent_255(product)) return true;
        }
        return agree_as_promised<2>(result, expected, arguments);
      });
}

#ifdef SPU_EMU_PRECISE
TEST_F(FLOAT_SUITE, NeedsNoStatusFlagsForZeroAndOverflow) {
  EXPECT_EQ(image(spu_mul(spu_splats(-1.0f), V{})), image(V{}));
  const V large = (V)spu_splats(0x7f800000U);
  EXPECT_EQ(image(spu_add(large, large)), image(spu_splats(0x7fffffffU)));
}
#endif

}  // namespace
