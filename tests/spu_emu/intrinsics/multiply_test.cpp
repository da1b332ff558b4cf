#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

constexpr int left = 0;
constexpr int right = 1;

TEST(Multiply, MultipliesEvenAndOddHalfwords) {
  using S = vec_short8;
  using U = vec_ushort8;
  const auto product = [](auto p) { return p; };
  check<S, S>(
      "spu_mule", [](S a, S b) { return spu_mule(a, b); }, halfword_products(left, left, product));
  check<U, U>(
      "spu_mule", [](U a, U b) { return spu_mule(a, b); }, unsigned_halfword_products(left, left, product));
  check<S, S>(
      "spu_mulo", [](S a, S b) { return spu_mulo(a, b); }, halfword_products(right, right, product));
  check<U, U>(
      "spu_mulo", [](U a, U b) { return spu_mulo(a, b); }, unsigned_halfword_products(right, right, product));
  check<S, short>(
      "spu_mulo", [](S a, short b) { return spu_mulo(a, b); },
      with_splat<2>(halfword_products(right, right, product)));
  check<U, unsigned short>(
      "spu_mulo", [](U a, unsigned short b) { return spu_mulo(a, b); },
      with_splat<2>(unsigned_halfword_products(right, right, product)));
}

TEST(Multiply, AddsProductsToWords) {
  using S = vec_short8;
  using U = vec_ushort8;
  const auto plus = [](auto p, auto c) { return p + c; };
  check<S, S, vec_int4>(
      "spu_madd", [](S a, S b, vec_int4 c) { return spu_madd(a, b, c); },
      halfword_products(right, right, plus));
  check<S, S, vec_int4>(
      "spu_mhhadd", [](S a, S b, vec_int4 c) { return spu_mhhadd(a, b, c); },
      halfword_products(left, left, plus));
  check<U, U, vec_uint4>(
      "spu_mhhadd", [](U a, U b, vec_uint4 c) { return spu_mhhadd(a, b, c); },
      unsigned_halfword_products(left, left, plus));
}

TEST(Multiply, TakesPartsOfProducts) {
  using S = vec_short8;
  check<S, S>(
      "spu_mulh", [](S a, S b) { return spu_mulh(a, b); },
      halfword_products(left, right, [](s64 p) { return static_cast<u64>(p) << 16; }));
  check<S, S>(
      "spu_mulsr", [](S a, S b) { return spu_mulsr(a, b); },
      halfword_products(right, right, [](s64 p) { return p >> 16; }));
}

}  // namespace
