#include <vmx2spu.h>

#include "check.h"
#include "operations.h"

#include <algorithm>

namespace {

using namespace reference;

// Lanes of a then of b, of Width bytes, made into half-width lanes by f of the sign- or zero-extended value.
template <int Width, bool Signed, typename F>
auto packed(F f) {
  return [f](const Register& a, const Register& b) {
    return build<Width / 2>([&](int i) {
      const Register& from = i < lanes<Width> ? a : b;
      const int k = i % lanes<Width>;
      return f(Signed ? signed_lane<Width>(from, k) : static_cast<s64>(lane<Width>(from, k)));
    });
  };
}

auto between(s64 least, s64 largest) {
  return [=](s64 v) { return std::min(std::max(v, least), largest); };
}

s64 unchanged(s64 v) {
  return v;
}

TEST(VmxPack, KeepsTheRightHalves) {
  check<vec_ushort8, vec_ushort8>(
      "vec_pack", [](auto a, auto b) { return vec_pack(a, b); }, packed<2, false>(unchanged));
  check<vec_short8, vec_short8>(
      "vec_pack", [](auto a, auto b) { return vec_pack(a, b); }, packed<2, true>(unchanged));
  check<vec_uint4, vec_uint4>(
      "vec_pack", [](auto a, auto b) { return vec_pack(a, b); }, packed<4, false>(unchanged));
  check<vec_int4, vec_int4>(
      "vec_pack", [](auto a, auto b) { return vec_pack(a, b); }, packed<4, true>(unchanged));
}

TEST(VmxPack, Saturates) {
  const auto packs = [](auto a, auto b) { return vec_packs(a, b); };
  const auto packsu = [](auto a, auto b) { return vec_packsu(a, b); };
  check<vec_ushort8, vec_ushort8>("vec_packs", packs, packed<2, false>(between(0, 255)));
  check<vec_short8, vec_short8>("vec_packs", packs, packed<2, true>(between(-128, 127)));
  check<vec_uint4, vec_uint4>("vec_packs", packs, packed<4, false>(between(0, 65535)));
  check<vec_int4, vec_int4>("vec_packs", packs, packed<4, true>(between(-32768, 32767)));
  check<vec_ushort8, vec_ushort8>("vec_packsu", packsu, packed<2, false>(between(0, 255)));
  check<vec_short8, vec_short8>("vec_packsu", packsu, packed<2, true>(between(0, 255)));
  check<vec_uint4, vec_uint4>("vec_packsu", packsu, packed<4, false>(between(0, 65535)));
  check<vec_int4, vec_int4>("vec_packsu", packsu, packed<4, true>(between(0, 65535)));
}

TEST(VmxPack, PacksPixels) {
  check<vec_uint4, vec_uint4>(
      "vec_packpx", [](auto a, auto b) { return vec_packpx(a, b); }, packed<4, false>([](s64 w) {
        return (w >> 24 & 1) << 15 | (w >> 19 & 31) << 10 | (w >> 11 & 31) << 5 | (w >> 3 & 31);
      }));
}

// Lanes of the left (Half 0) or right (1) half, widened.
template <int Width, int Half>
Register unpacked(const Register& a) {
  return build<2 * Width>([&](int i) { return signed_lane<Width>(a, i + Half * lanes<2 * Width>); });
}

TEST(VmxUnpack, SignExtendsHalvesAndBooleans) {
  for_types<vec_char16, vec_bchar16>([](auto type) {
    using V = TYPE_OF(type);
    check<V>(
        "vec_unpackh", [](V a) { return vec_unpackh(a); }, unpacked<1, 0>);
    check<V>(
        "vec_unpackl", [](V a) { return vec_unpackl(a); }, unpacked<1, 1>);
  });
  for_types<vec_short8, vec_bshort8>([](auto type) {
    using V = TYPE_OF(type);
    check<V>(
        "vec_unpackh", [](V a) { return vec_unpackh(a); }, unpacked<2, 0>);
    check<V>(
        "vec_unpackl", [](V a) { return vec_unpackl(a); }, unpacked<2, 1>);
  });
}

TEST(VmxUnpack, WidensPixels) {
  using spu_emu::detail::left_words;
  using spu_emu::detail::pixel_to_word;
  check<vec_pixel8>(
      "pixel_to_word", [](vec_pixel8 p) { return pixel_to_word(left_words(p)); },
      [](const Register& a) {
        return build<4>([&](int i) {
          const u64 p = lane<2>(a, i);
          return (p >> 15 != 0 ? u64{0xff000000} : 0) | (p >> 10 & 31) << 16 | (p >> 5 & 31) << 8 | (p & 31);
        });
      });
}

TEST(VmxMerge, AlternatesElementsOfHalves) {
  for_types<vec_uchar16, vec_char16, vec_ushort8, vec_short8, vec_uint4, vec_int4, vec_float4>([](auto type) {
    using V = TYPE_OF(type);
    constexpr int width = width_of<V>;
    check<V, V>(
        "vec_mergeh", [](V a, V b) { return vec_mergeh(a, b); },
        [](const Register& a, const Register& b) {
          return build<width>([&](int i) { return lane<width>(i % 2 == 0 ? a : b, i / 2); });
        });
    check<V, V>(
        "vec_mergel", [](V a, V b) { return vec_mergel(a, b); },
        [](const Register& a, const Register& b) {
          return build<width>(
              [&](int i) { return lane<width>(i % 2 == 0 ? a : b, i / 2 + lanes<width> / 2); });
        });
  });
}

}  // namespace
