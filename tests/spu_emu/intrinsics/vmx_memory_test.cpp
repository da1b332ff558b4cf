#include <vmx2spu.h>

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "check.h"

namespace {

using namespace reference;

// Two quadwords with known bytes around a vector's worth of elements.
struct alignas(16) Buffer {
  unsigned char bytes[48];
  Buffer() { std::iota(bytes, bytes + 48, static_cast<unsigned char>(1)); }
};

template <typename V>
V from_memory(const unsigned char* bytes) {
  V v;
  std::memcpy(&v, bytes, 16);
  return v;
}

template <typename F>
void for_loadable_types(F f) {
  for_types<vec_uchar16, vec_char16, vec_ushort8, vec_short8, vec_uint4, vec_int4, vec_float4>(f);
}

TEST(VmxMemory, LoadsAndStoresAlignedQuadwords) {
  for_loadable_types([](auto type) {
    using V = TYPE_OF(type);
    using E = ElementOf<V>;
    Buffer buffer;
    auto* elements = reinterpret_cast<E*>(buffer.bytes);
    auto* vectors = reinterpret_cast<V*>(buffer.bytes);
    for (const int offset : {0, 3, 15, 16, 31}) {
      const V expected = from_memory<V>(buffer.bytes + offset / 16 * 16);
      EXPECT_EQ(image(vec_ld(offset, elements)), image(expected));
      EXPECT_EQ(image(vec_ld(offset, vectors)), image(expected));
      EXPECT_EQ(image(vec_ldl(offset, elements)), image(expected));
    }
    const V value = from_memory<V>(buffer.bytes + 16);
    vec_st(value, 5, elements);
    EXPECT_EQ(image(vec_ld(0, vectors)), image(value));
    vec_stl(value, 33, vectors);
    EXPECT_EQ(image(vec_ld(32, vectors)), image(value));
  });
}

TEST(VmxMemory, LoadsAndStoresSingleElements) {
  for_loadable_types([](auto type) {
    using V = TYPE_OF(type);
    using E = ElementOf<V>;
    Buffer buffer;
    auto* elements = reinterpret_cast<E*>(buffer.bytes);
    const V other = from_memory<V>(buffer.bytes + 32);
    for (int i = 0; i < lanes<sizeof(E)>; ++i) {
      const int offset = i * static_cast<int>(sizeof(E));
      EXPECT_EQ(std::memcmp(reinterpret_cast<const E*>(buffer.bytes) + i,
                            reinterpret_cast<const char*>(&elements[i]), sizeof(E)),
                0);
      EXPECT_EQ(image(vec_lde(offset, elements)), image(from_memory<V>(buffer.bytes)));
      EXPECT_EQ(image(vec_lde(offset + 16, elements)), image(from_memory<V>(buffer.bytes + 16)));
      vec_ste(other, offset, elements);
      EXPECT_EQ(elements[i], other[i]);
    }
  });
}

TEST(VmxMemory, LoadsUnalignedVectorsInTwoParts) {
  for_loadable_types([](auto type) {
    using V = TYPE_OF(type);
    using E = ElementOf<V>;
    Buffer buffer;
    auto* elements = reinterpret_cast<E*>(buffer.bytes);
    for (int offset = 0; offset < 16; offset += static_cast<int>(sizeof(E))) {
      const V both = vec_or(vec_lvlx(offset, elements), vec_lvrx(offset + 16, elements));
      EXPECT_EQ(image(both), image(from_memory<V>(buffer.bytes + offset)));
      const V by_pattern =
          vec_perm(vec_ld(offset, elements), vec_ld(offset + 15, elements), vec_lvsl(offset, elements));
      EXPECT_EQ(image(by_pattern), image(both));
      EXPECT_EQ(image(vec_lvlxl(offset, elements)), image(vec_lvlx(offset, elements)));
      EXPECT_EQ(image(vec_lvrxl(offset, elements)), image(vec_lvrx(offset, elements)));
    }
  });
}

TEST(VmxMemory, StoresUnalignedVectorsInTwoParts) {
  for_loadable_types([](auto type) {
    using V = TYPE_OF(type);
    using E = ElementOf<V>;
    for (int offset = 0; offset < 16; offset += static_cast<int>(sizeof(E))) {
      Buffer buffer;
      const Buffer before;
      auto* elements = reinterpret_cast<E*>(buffer.bytes);
      const V value = from_memory<V>(before.bytes + 32);
      vec_stvlx(value, offset, elements);
      vec_stvrx(value, offset + 16, elements);
      EXPECT_EQ(std::memcmp(buffer.bytes, before.bytes, static_cast<std::size_t>(offset)), 0);
      EXPECT_EQ(image(from_memory<V>(buffer.bytes + offset)), image(value));
      EXPECT_EQ(std::memcmp(buffer.bytes + offset + 16, before.bytes + offset + 16,
                            static_cast<std::size_t>(32 - offset)),
                0);
      vec_stvlxl(value, 0, elements);
      vec_stvrxl(value, 0, elements);
      EXPECT_EQ(image(from_memory<V>(buffer.bytes)), image(value));
    }
  });
}

TEST(VmxMemory, MakesAlignmentPatterns) {
  Buffer buffer;
  for (int offset = 0; offset < 16; ++offset) {
    EXPECT_EQ(image(vec_lvsl(offset, buffer.bytes)), build<1>([&](int i) { return i + offset; }));
    EXPECT_EQ(image(vec_lvsr(offset, buffer.bytes)), build<1>([&](int i) { return i + 16 - offset; }));
  }
}

TEST(VmxMemory, HasNoVectorStatusAndNoDataStreams) {
  vec_mtvscr(vec_uint4{1, 2, 3, 4});
  EXPECT_EQ(image(vec_mfvscr()), Register{});
  vec_dss(0);
  vec_dssall();
  vec_dst(nullptr, 0, 0);
  vec_dstst(nullptr, 0, 0);
  vec_dststt(nullptr, 0, 0);
  vec_dstt(nullptr, 0, 0);
}

}  // namespace
