#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

TEST(Bits, CountsOnesInBytes) {
  for_types<vec_char16, vec_uchar16>([](auto type) {
    using V = TYPE_OF(type);
    check<V>(
        "spu_cntb", [](V a) { return spu_cntb(a); }, lanewise<1>([](u64 a) { return ones_in(a); }));
  });
}

TEST(Bits, CountsLeadingZerosOfWords) {
  for_types<vec_int4, vec_uint4, vec_float4>([](auto type) {
    using V = TYPE_OF(type);
    check<V>(
        "spu_cntlz", [](V a) { return spu_cntlz(a); }, lanewise<4>(leading_zeros32));
  });
}

TEST(Bits, GathersTheLowestBitOfEveryElement) {
  for_types<vec_int4, vec_uint4, vec_short8, vec_ushort8, vec_char16, vec_uchar16, vec_float4>([](auto type) {
    using V = TYPE_OF(type);
    check<V>(
        "spu_gather", [](V a) { return spu_gather(a); }, gathered<width_of<V>>);
  });
}

TEST(Bits, ExpandsBitsIntoMasks) {
  for_types<unsigned short, short, unsigned int, int>([](auto type) {
    using S = TYPE_OF(type);
    check<S>(
        "spu_maskb", [](S s) { return spu_maskb(s); }, [](S s) { return mask_of<1>(static_cast<u64>(s)); });
  });
  for_types<unsigned char, signed char, unsigned short, short, unsigned int, int>([](auto type) {
    using S = TYPE_OF(type);
    check<S>(
        "spu_maskh", [](S s) { return spu_maskh(s); }, [](S s) { return mask_of<2>(static_cast<u64>(s)); });
    check<S>(
        "spu_maskw", [](S s) { return spu_maskw(s); }, [](S s) { return mask_of<4>(static_cast<u64>(s)); });
  });
}

}  // namespace
