#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

TEST(Shuffle, PicksTheBytesThatAnSpuWouldPickForEveryType) {
  for_all_types([](auto type) {
    using V = TYPE_OF(type);
    using P = vec_uchar16;
    check<V, V, P>(
        "spu_shuffle", [](V a, V b, P p) { return spu_shuffle(a, b, p); }, shuffled);
  });
}

/// The compiler sees the pattern and may choose an instruction of its own.
template <typename V, typename Pattern>
void check_literal(Pattern pattern) {
  check<V, V>(
      "spu_shuffle by a literal", [=](V a, V b) { return spu_shuffle(a, b, pattern()); },
      [=](const Register& a, const Register& b) { return shuffled(a, b, image(pattern())); });
  check<V>(
      "spu_shuffle of one vector", [=](V a) { return spu_shuffle(a, a, pattern()); },
      [=](const Register& a) { return shuffled(a, a, image(pattern())); });
}

TEST(Shuffle, PicksTheSameBytesByPatternsThatTheCompilerKnows) {
  using P = vec_uchar16;
  for_all_types([](auto type) {
    using V = TYPE_OF(type);
    check_literal<V>([] { return P{12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}; });
    check_literal<V>([] { return P{4, 5, 6, 7, 20, 21, 22, 23, 0, 1, 2, 3, 28, 29, 30, 31}; });
    check_literal<V>([] { return P{15, 30, 13, 28, 11, 26, 9, 24, 7, 22, 5, 20, 3, 18, 1, 16}; });
    check_literal<V>([] { return P{3, 3, 3, 3, 0x7f, 0x60, 0x21, 0x5e, 1, 2, 3, 4, 5, 6, 7, 8}; });
    check_literal<V>([] { return P{0, 1, 2, 3, 0x80, 0xc0, 0xe0, 0xff, 8, 9, 10, 11, 0xbf, 0xdf, 30, 31}; });
  });
}

TEST(Shuffle, MovesWholeWordsByPatternsAsSdkSourcesWriteThem) {
  const vec_float4 a = {1, 2, 3, 4};
  const vec_float4 b = {5, 6, 7, 8};
  const vec_uchar16 pattern = {4, 5, 6, 7, 20, 21, 22, 23, 0, 1, 2, 3, 28, 29, 30, 31};
  EXPECT_EQ(image(spu_shuffle(a, b, pattern)), image(vec_float4{2, 6, 1, 8}));
  // Also after a cast that changed the element width: words move whole.
  const vec_uchar16 bytes = spu_shuffle((vec_uchar16)a, (vec_uchar16)b, pattern);
  EXPECT_EQ(image((vec_float4)bytes), image(vec_float4{2, 6, 1, 8}));
}

TEST(Shuffle, SplitsWordsByPatternsAsSdkSourcesWriteThem) {
  const vec_uint4 words = {0x00112233, 0x44556677, 0x8899aabb, 0xccddeeff};
  const vec_uchar16 low_halves = {0x80, 0x80, 2, 3, 0x80, 0x80, 6, 7, 0x80, 0x80, 10, 11, 0x80, 0x80, 14, 15};
  EXPECT_EQ(image(spu_shuffle(words, words, low_halves)), image(vec_uint4{0x2233, 0x6677, 0xaabb, 0xeeff}));
}

TEST(Qword, ReinterpretsBetweenElementWidthsAsAnSpuDoes) {
  for_all_types([](auto type) {
    using V = TYPE_OF(type);
    const auto unchanged = [](const Register& a) { return a; };
    check<V>(
        "cast to qword", [](V a) { return (qword)a; }, unchanged);
    check<qword>(
        "cast from qword", [](qword a) { return (V)a; }, unchanged);
  });
  EXPECT_EQ(((vec_ushort8)(qword)vec_uint4{0x00010002, 0, 0, 0})[0], 1);
}

}  // namespace
