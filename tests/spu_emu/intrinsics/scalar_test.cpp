#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

template <typename E>
u64 raw(E element) {
  u64 b = 0;
  std::memcpy(&b, &element, sizeof element);
  return b;
}

TEST(Scalars, SplatAndPromoteAndComeBack) {
  for_all_types([](auto type) {
    using V = TYPE_OF(type);
    using E = ElementOf<V>;
    constexpr int width = width_of<V>;
    check<E>(
        "spu_splats", [](E s) { return spu_splats(s); },
        [](E s) { return build<width>([&](int) { return raw(s); }); });
    check<E, int>(
        "spu_promote", [](E s, int n) { return raw(spu_extract(spu_promote(s, n), n)); },
        [](E s, int) { return raw(s); });
    check<V, int>(
        "spu_extract", [](V v, int n) { return raw(spu_extract(v, n)); },
        [](const Register& r, int n) { return lane<width>(r, n & (lanes<width> - 1)); });
    check<E, V, int>(
        "spu_insert", [](E s, V v, int n) { return spu_insert(s, v, n); },
        [](E s, Register r, int n) {
          put<width>(r, n & (lanes<width> - 1), raw(s));
          return r;
        });
  });
}

TEST(Scalars, SitInThePreferredSlotOfAQword) {
  const Register r = build<1>([](int i) { return 0x10 + i; });
  const qword q = vector<qword>(r);
  EXPECT_EQ(si_to_char(q), 0x13);
  EXPECT_EQ(si_to_uchar(q), 0x13);
  EXPECT_EQ(si_to_short(q), 0x1213);
  EXPECT_EQ(si_to_ushort(q), 0x1213);
  EXPECT_EQ(si_to_int(q), 0x10111213);
  EXPECT_EQ(si_to_uint(q), 0x10111213U);
  EXPECT_EQ(si_to_llong(q), 0x1011121314151617LL);
  EXPECT_EQ(si_to_ullong(q), 0x1011121314151617ULL);
  EXPECT_EQ(raw(si_to_float(q)), 0x10111213U);
  EXPECT_EQ(raw(si_to_double(q)), 0x1011121314151617ULL);
}

template <typename S, typename From, typename To>
void check_round_trip(const char* name, From from, To to) {
  constexpr int width = sizeof(S);
  check<S>(name, from, [](S s) { return build<width>([&](int) { return raw(s); }); });
  check<S>(
      name, [&](S s) { return raw(to(from(s))); }, [](S s) { return raw(s); });
}

TEST(Scalars, GoToQwordsAndBack) {
  check_round_trip<signed char>(
      "si_from_char", [](auto s) { return si_from_char(s); }, si_to_char);
  check_round_trip<unsigned char>(
      "si_from_uchar", [](auto s) { return si_from_uchar(s); }, si_to_uchar);
  check_round_trip<short>(
      "si_from_short", [](auto s) { return si_from_short(s); }, si_to_short);
  check_round_trip<unsigned short>(
      "si_from_ushort", [](auto s) { return si_from_ushort(s); }, si_to_ushort);
  check_round_trip<int>(
      "si_from_int", [](auto s) { return si_from_int(s); }, si_to_int);
  check_round_trip<unsigned>(
      "si_from_uint", [](auto s) { return si_from_uint(s); }, si_to_uint);
  check_round_trip<long long>(
      "si_from_llong", [](auto s) { return si_from_llong(s); }, si_to_llong);
  check_round_trip<unsigned long long>(
      "si_from_ullong", [](auto s) { return si_from_ullong(s); }, si_to_ullong);
  check_round_trip<float>(
      "si_from_float", [](auto s) { return si_from_float(s); }, si_to_float);
  check_round_trip<double>(
      "si_from_double", [](auto s) { return si_from_double(s); }, si_to_double);
  int object = 0;
  EXPECT_EQ(si_to_ptr(si_from_ptr(&object)), &object);
}

}  // namespace
