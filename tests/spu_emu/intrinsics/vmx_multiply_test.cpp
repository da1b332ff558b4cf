#include <vmx2spu.h>

#include "check.h"
#include "operations.h"

#include <algorithm>

namespace {

using namespace reference;

s64 saturated_word(s64 v) {
  return std::min<s64>(std::max<s64>(v, INT32_MIN), INT32_MAX);
}
s64 saturated_half(s64 v) {
  return std::min<s64>(std::max<s64>(v, INT16_MIN), INT16_MAX);
}
s64 low_half_of(s64 v) {
  return static_cast<std::int16_t>(v);
}
s64 low_word_of(s64 v) {
  return static_cast<std::int32_t>(v);
}

// Products of even (0) or odd (1) lanes of Width bytes into lanes of twice that.
template <int Width, bool Signed, int Odd>
Register products(const Register& a, const Register& b) {
  return build<2 * Width>([&](int i) {
    const int k = 2 * i + Odd;
    return Signed ? static_cast<u64>(signed_lane<Width>(a, k) * signed_lane<Width>(b, k))
                  : lane<Width>(a, k) * lane<Width>(b, k);
  });
}

template <typename V, int Width, bool Signed>
void check_products() {
  check<V, V>(
      "vec_mule", [](V a, V b) { return vec_mule(a, b); }, products<Width, Signed, 0>);
  check<V, V>(
      "vec_mulo", [](V a, V b) { return vec_mulo(a, b); }, products<Width, Signed, 1>);
}

TEST(VmxMultiply, MultipliesEvenAndOddElements) {
  check_products<vec_uchar16, 1, false>();
  check_products<vec_char16, 1, true>();
  check_products<vec_ushort8, 2, false>();
  check_products<vec_short8, 2, true>();
}

TEST(VmxMultiply, MultipliesAndAddsHalfwords) {
  using S = vec_short8;
  using U = vec_ushort8;
  const auto mladd = [](auto a, auto b, auto c) { return vec_mladd(a, b, c); };
  const auto low_half = lanewise<2>([](u64 a, u64 b, u64 c) { return a * b + c; });
  check<S, S, S>("vec_mladd", mladd, low_half);
  check<U, U, U>("vec_mladd", mladd, low_half);
  check<U, S, S>("vec_mladd", mladd, low_half);
  check<S, U, U>("vec_mladd", mladd, low_half);
  check<S, S, S>(
      "vec_madds", [](S a, S b, S c) { return vec_madds(a, b, c); },
      signed_lanewise<2>([](s64 a, s64 b, s64 c) { return saturated_half(low_half_of(a * b >> 15) + c); }));
  check<S, S, S>(
      "vec_mradds", [](S a, S b, S c) { return vec_mradds(a, b, c); },
      signed_lanewise<2>(
          [](s64 a, s64 b, s64 c) { return saturated_half(low_half_of((a * b + 0x4000) >> 15) + c); }));
}

// The sum of the products within each word and of c's word, handed to finish.
template <int Width, bool SignedA, bool SignedB, bool SignedC, typename F>
auto multiply_sum(F finish) {
  return [finish](const Register& a, const Register& b, const Register& c) {
    return build<4>([&](int i) {
      s64 sum = SignedC ? signed_lane<4>(c, i) : static_cast<s64>(lane<4>(c, i));
      for (int k = i * 4 / Width; k < (i + 1) * 4 / Width; ++k) {
        const s64 x = SignedA ? signed_lane<Width>(a, k) : static_cast<s64>(lane<Width>(a, k));
        const s64 y = SignedB ? signed_lane<Width>(b, k) : static_cast<s64>(lane<Width>(b, k));
        sum += x * y;
      }
      return finish(sum);
    });
  };
}

TEST(VmxMultiply, SumsProductsWithinWords) {
  const auto msum = [](auto a, auto b, auto c) { return vec_msum(a, b, c); };
  const auto msums = [](auto a, auto b, auto c) { return vec_msums(a, b, c); };
  const auto wrapped = [](s64 v) { return v; };
  const auto saturated_unsigned = [](s64 v) { return std::min<s64>(v, UINT32_MAX); };
  check<vec_uchar16, vec_uchar16, vec_uint4>("vec_msum", msum, multiply_sum<1, false, false, false>(wrapped));
  check<vec_char16, vec_uchar16, vec_int4>("vec_msum", msum, multiply_sum<1, true, false, true>(wrapped));
  check<vec_ushort8, vec_ushort8, vec_uint4>("vec_msum", msum, multiply_sum<2, false, false, false>(wrapped));
  check<vec_short8, vec_short8, vec_int4>("vec_msum", msum, multiply_sum<2, true, true, true>(wrapped));
  check<vec_ushort8, vec_ushort8, vec_uint4>("vec_msums", msums,
                                             multiply_sum<2, false, false, false>(saturated_unsigned));
  check<vec_short8, vec_short8, vec_int4>(
      "vec_msums", msums, [=](const Register& a, const Register& b, const Register& c) {
        const Register sums = multiply_sum<2, true, true, true>(low_word_of)(a, b, Register{});
        return signed_lanewise<4>([](s64 sum, s64 z) { return saturated_word(sum + z); })(sums, c);
      });
  const vec_short8 least = spu_splats(static_cast<short>(-32768));
  EXPECT_EQ(image(vec_msums(least, least, vec_int4{})), image(spu_splats(INT32_MIN)));
  EXPECT_EQ(image(vec_madds(least, least, vec_short8{})), image(least));
  EXPECT_EQ(image(vec_mradds(least, least, vec_short8{})), image(least));
}

template <int Width, bool Signed, typename F>
auto sum_within_words(F finish) {
  const Register ones = build<Width>([](int) { return 1; });
  return [=](const Register& a, const Register& b) {
    return multiply_sum<Width, Signed, Signed, Signed>(finish)(a, ones, b);
  };
}

TEST(VmxMultiply, SumsElementsAcross) {
  const auto sum4s = [](auto a, auto b) { return vec_sum4s(a, b); };
  check<vec_uchar16, vec_uint4>(
      "vec_sum4s", sum4s, sum_within_words<1, false>([](s64 v) { return std::min<s64>(v, UINT32_MAX); }));
  check<vec_char16, vec_int4>("vec_sum4s", sum4s, sum_within_words<1, true>(saturated_word));
  check<vec_short8, vec_int4>("vec_sum4s", sum4s, sum_within_words<2, true>(saturated_word));
  using W = vec_int4;
  check<W, W>(
      "vec_sum2s", [](W a, W b) { return vec_sum2s(a, b); },
      [](const Register& a, const Register& b) {
        return build<4>([&](int i) {
          return i % 2 == 0
                     ? 0
                     : saturated_word(signed_lane<4>(a, i - 1) + signed_lane<4>(a, i) + signed_lane<4>(b, i));
        });
      });
  check<W, W>(
      "vec_sums", [](W a, W b) { return vec_sums(a, b); },
      [](const Register& a, const Register& b) {
        s64 sum = signed_lane<4>(b, 3);
        for (int i = 0; i < 4; ++i) sum += signed_lane<4>(a, i);
        return build<4>([&](int i) { return i < 3 ? 0 : saturated_word(sum); });
      });
}

}  // namespace
