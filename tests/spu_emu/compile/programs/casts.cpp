// Casts between vectors of all element widths, in the forms in which programs write them. The same on an SPU.
#include <spu_intrinsics.h>

typedef vec_uchar16 Pattern;
using Halves = vec_ushort8;

struct Pair {
  vec_uint4 words[2];
  const vec_uint4& second() const { return words[1]; }
};

static const vec_uint4 words = {0x00010203, 0x04050607, 0x08090a0b, 0x0c0d0e0f};
static const vec_uchar16 constant = (vec_uchar16)(vec_uint4){0x10111213, 0x14151617, 0x18191a1b, 0x1c1d1e1f};

template <class V>
static bool counts_up(V v, unsigned first) {
  const vec_uchar16 bytes = (vec_uchar16)v;
  for (int i = 0; i < 16; ++i) {
    if (spu_extract(bytes, i) != first + i) return false;
  }
  return true;
}

template <class To, class From>
static To seen_as(From from) {
  const To same = (To)from;
  return To(same);
}
template <class T>
struct Narrow {
  using Type = vec_ushort8;
};
template <class T>
struct Holder {
  T value;
  vec_ushort8 halves() const { return (typename Narrow<T>::Type)value; }
};

static int sum(vec_ushort8 halves, vec_uchar16 bytes) {
  return spu_extract(halves, 1) + spu_extract(bytes, 15);
}

int main(unsigned long long, unsigned long long, unsigned long long) {
  const Pair pair = {{words, (vec_uint4)constant}};
  if (!counts_up(words, 0) || !counts_up((vec_ushort8)words, 0)) return 1;
  if (!counts_up((vec_float4)(vec_ullong2)(Halves)words, 0)) return 2;
  if (!counts_up(constant, 16) || !counts_up((vec_double2)pair.second(), 16)) return 3;
  if (spu_extract((vec_ullong2)words, 1) != 0x08090a0b0c0d0e0fULL) return 4;
  if (spu_extract((vec_ushort8)pair.words[1], 2) != 0x1415) return 5;
  if (spu_extract((Pattern)words + (Pattern)constant, 15) != 0x2e) return 6;
  if (spu_extract((vec_short8) - (vec_int4)words, 0) != -2) return 7;
  if (spu_extract(reinterpret_cast<vec_uchar16>(~(vec_ushort8)words), 1) != 0xfe) return 8;
  if (sum((vec_ushort8)words, (vec_uchar16)spu_add(words, 1U)) != 0x0203 + 0x10) return 9;
  const bool is_low = true;
  if (spu_extract(is_low ? (vec_uchar16)words : constant, 3) != 3) return 10;
  const vec_uint4* const pointer = &words;
  if (spu_extract((vec_uchar16)*pointer, 7) != 7 || spu_extract((vec_uchar16)pointer[0], 8) != 8) return 11;
  if (sizeof(vec_uchar16) * 2 != 32 || spu_extract((vec_int4)spu_splats(1.0F), 0) != 0x3f800000) return 12;
  if (spu_extract((vec_uchar16)si_ai((qword)words, 1), 15) != 0x10) return 13;
  const vec_uchar16 mixed = spu_shuffle((vec_uchar16)words, constant, (vec_uchar16)(vec_ushort8)words);
  if (!counts_up(seen_as<vec_ushort8>(words), 0) || !counts_up(seen_as<vec_double2>(constant), 16)) return 14;
  if (seen_as<int>(3.75F) != 3 || seen_as<const unsigned char*>(&words) == nullptr) return 15;
  if (!counts_up(Halves(words), 0) || spu_extract(Holder<vec_uint4>{words}.halves(), 7) != 0x0e0f) return 16;
  const vec_uchar16 as_mixed = (decltype(mixed))words + (__typeof__(mixed))spu_splats((unsigned short)0);
  const vec_uint4& same = static_cast<decltype((words))>(words);
  if (!counts_up(as_mixed, 0) || (decltype(is_low))spu_extract(same, 0) != true) return 18;
  return counts_up(mixed, 0) ? 42 : 17;
}
