#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

TEST(Quadword, RotatesByBitsAndBytes) {
  for_all_types([](auto type) {
    using V = TYPE_OF(type);
    check<V, int>(
        "spu_rlqw", [](V a, int n) { return spu_rlqw(a, n); },
        [](const Register& a, int n) { return moved_around(a, n & 7); });
    check<V, int>(
        "spu_rlqwbyte", [](V a, int n) { return spu_rlqwbyte(a, n); },
        [](const Register& a, int n) { return moved_around(a, (n & 15) * 8); });
    check<V, int>(
        "spu_rlqwbytebc", [](V a, int n) { return spu_rlqwbytebc(a, n); },
        [](const Register& a, int n) { return moved_around(a, n & 0x78); });
  });
}

TEST(Quadword, ShiftsRightByNegatedCounts) {
  for_all_types([](auto type) {
    using V = TYPE_OF(type);
    check<V, int>(
        "spu_rlmaskqw", [](V a, int n) { return spu_rlmaskqw(a, n); },
        [](const Register& a, int n) { return moved_left(a, -(-static_cast<long>(n) & 7)); });
    check<V, int>(
        "spu_rlmaskqwbyte", [](V a, int n) { return spu_rlmaskqwbyte(a, n); },
        [](const Register& a, int n) {
          return moved_left(a, static_cast<int>(-8 * (-static_cast<long>(n) & 31)));
        });
    check<V, int>(
        "spu_rlmaskqwbytebc", [](V a, int n) { return spu_rlmaskqwbytebc(a, n); },
        [](const Register& a, int n) { return moved_left(a, -8 * (-(n >> 3) & 31)); });
  });
}

}  // namespace
