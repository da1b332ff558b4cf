// Built twice, with and without SPU_EMU_PRECISE: the compare rule holds for all inputs in both.
#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

using V = vec_float4;

s64 key(u64 word) {
  const s64 size = static_cast<s64>(word & 0x7fffffff);
  if (size < 0x00800000) return 0;
  return word >> 31 != 0 ? -size : size;
}

s64 absolute_key(u64 word) {
  return key(word & 0x7fffffff);
}

#ifdef SPU_EMU_PRECISE
TEST(PreciseFloatCompare, FollowsTheHardwaresRuleForAllPatterns) {
#else
TEST(DefaultFloatCompare, FollowsTheHardwaresRuleForAllPatterns) {
  const spu_emu::SpuFloatMode mode;
#endif
  check<V, V>(
      "spu_cmpeq", [](V a, V b) { return spu_cmpeq(a, b); },
      lanewise<4>([](u64 a, u64 b) { return all_ones(key(a) == key(b)); }));
  check<V, V>(
      "spu_cmpgt", [](V a, V b) { return spu_cmpgt(a, b); },
      lanewise<4>([](u64 a, u64 b) { return all_ones(key(a) > key(b)); }));
  check<V, V>(
      "spu_cmpabseq", [](V a, V b) { return spu_cmpabseq(a, b); },
      lanewise<4>([](u64 a, u64 b) { return all_ones(absolute_key(a) == absolute_key(b)); }));
  check<V, V>(
      "spu_cmpabsgt", [](V a, V b) { return spu_cmpabsgt(a, b); },
      lanewise<4>([](u64 a, u64 b) { return all_ones(absolute_key(a) > absolute_key(b)); }));
}

}  // namespace
