#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

int bit_count(unsigned n) {
  return static_cast<int>(n % 8);
}
int byte_count(unsigned n) {
  return static_cast<int>(n % 32) * 8;
}
int byte_count_from_bits(unsigned n) {
  return static_cast<int>(n / 8 % 32) * 8;
}

TEST(Quadword, ShiftsLeftByBitsAndBytes) {
  for_all_types([](auto type) {
    using V = TYPE_OF(type);
    check<V, unsigned>(
        "spu_slqw", [](V a, unsigned n) { return spu_slqw(a, n); },
        [](const Register& a, unsigned n) { return moved_left(a, bit_count(n)); });
    check<V, unsigned>(
        "spu_slqwbyte", [](V a, unsigned n) { return spu_slqwbyte(a, n); },
        [](const Register& a, unsigned n) { return moved_left(a, byte_count(n)); });
    check<V, unsigned>(
        "spu_slqwbytebc", [](V a, unsigned n) { return spu_slqwbytebc(a, n); },
        [](const Register& a, unsigned n) { return moved_left(a, byte_count_from_bits(n)); });
  });
}

TEST(Quadword, ShiftsRightByBitsAndBytes) {
  for_all_types([](auto type) {
    using V = TYPE_OF(type);
    check<V, unsigned>(
        "spu_srqw", [](V a, unsigned n) { return spu_srqw(a, n); },
        [](const Register& a, unsigned n) { return moved_left(a, -bit_count(n)); });
    check<V, unsigned>(
        "spu_srqwbyte", [](V a, unsigned n) { return spu_srqwbyte(a, n); },
        [](const Register& a, unsigned n) { return moved_left(a, -byte_count(n)); });
    check<V, unsigned>(
        "spu_srqwbytebc", [](V a, unsigned n) { return spu_srqwbytebc(a, n); },
        [](const Register& a, unsigned n) { return moved_left(a, -byte_count_from_bits(n)); });
  });
}

}  // namespace
