#include <vmx2spu.h>

#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

// Numbers in the order of V's elements; floats by the SPU's rule.
template <typename V>
s64 key(const Register& r, int i) {
  constexpr int width = width_of<V>;
  if constexpr (std::is_same_v<V, vec_float4>) {
    const u64 w = lane<4>(r, i);
    const s64 size = static_cast<s64>(w & 0x7fffffff);
    return size < 0x00800000 ? 0 : w >> 31 != 0 ? -size : size;
  } else {
    return std::is_signed_v<ElementOf<V>> ? signed_lane<width>(r, i) : static_cast<s64>(lane<width>(r, i));
  }
}

template <typename V, typename F>
auto all_of(F f) {
  return [f](const Register& a, const Register& b) {
    bool all = true;
    for (int i = 0; i < lanes<width_of<V>>; ++i) all = all && f(key<V>(a, i), key<V>(b, i));
    return all ? 1 : 0;
  };
}

template <typename V, typename F>
auto any_of(F f) {
  return [f](const Register& a, const Register& b) {
    bool any = false;
    for (int i = 0; i < lanes<width_of<V>>; ++i) any = any || f(key<V>(a, i), key<V>(b, i));
    return any ? 1 : 0;
  };
}

// Random vectors agree in no element, so b is also tried as a with few bits changed, and as a itself.
template <typename V, typename I, typename R>
void check_predicate(const char* name, I intrinsic, R ref) {
  using B = spu_emu::detail::Unsigned<V>;
  check<V, V>(name, intrinsic, ref);
  check<V, V>(
      name, [=](V a, V b) { return intrinsic(a, spu_and(a, b)); },
      [=](const Register& a, const Register& b) {
        return ref(a, lanewise<8>([](u64 x, u64 y) { return x & y; })(a, b));
      });
  check<V>(
      name, [=](V a) { return intrinsic(a, a); }, [=](const Register& a) { return ref(a, a); });
  if constexpr (!std::is_same_v<B, V> && !std::is_same_v<V, vec_float4>) {
    check<B, V>(name, intrinsic, ref);
    check<V, B>(name, intrinsic, ref);
  }
}

template <typename V>
void check_predicates() {
  const auto eq = [](s64 a, s64 b) { return a == b; };
  const auto ne = [](s64 a, s64 b) { return a != b; };
  const auto gt = [](s64 a, s64 b) { return a > b; };
  const auto lt = [](s64 a, s64 b) { return a < b; };
  const auto ge = [](s64 a, s64 b) { return a >= b; };
  const auto le = [](s64 a, s64 b) { return a <= b; };
  check_predicate<V>(
      "vec_all_eq", [](auto a, auto b) { return vec_all_eq(a, b); }, all_of<V>(eq));
  check_predicate<V>(
      "vec_all_ne", [](auto a, auto b) { return vec_all_ne(a, b); }, all_of<V>(ne));
  check_predicate<V>(
      "vec_all_gt", [](auto a, auto b) { return vec_all_gt(a, b); }, all_of<V>(gt));
  check_predicate<V>(
      "vec_all_lt", [](auto a, auto b) { return vec_all_lt(a, b); }, all_of<V>(lt));
  check_predicate<V>(
      "vec_all_ge", [](auto a, auto b) { return vec_all_ge(a, b); }, all_of<V>(ge));
  check_predicate<V>(
      "vec_all_le", [](auto a, auto b) { return vec_all_le(a, b); }, all_of<V>(le));
  check_predicate<V>(
      "vec_any_eq", [](auto a, auto b) { return vec_any_eq(a, b); }, any_of<V>(eq));
  check_predicate<V>(
      "vec_any_ne", [](auto a, auto b) { return vec_any_ne(a, b); }, any_of<V>(ne));
  check_predicate<V>(
      "vec_any_gt", [](auto a, auto b) { return vec_any_gt(a, b); }, any_of<V>(gt));
  check_predicate<V>(
      "vec_any_lt", [](auto a, auto b) { return vec_any_lt(a, b); }, any_of<V>(lt));
  check_predicate<V>(
      "vec_any_ge", [](auto a, auto b) { return vec_any_ge(a, b); }, any_of<V>(ge));
  check_predicate<V>(
      "vec_any_le", [](auto a, auto b) { return vec_any_le(a, b); }, any_of<V>(le));
}

TEST(VmxPredicates, AskAllOrAnyElements) {
  const spu_emu::SpuFloatMode mode;
  for_types<vec_uchar16, vec_char16, vec_ushort8, vec_short8, vec_uint4, vec_int4, vec_float4>(
      [](auto type) { check_predicates<TYPE_OF(type)>(); });
}

TEST(VmxPredicates, KnowNoUnorderedFloats) {
  using V = vec_float4;
  const spu_emu::SpuFloatMode mode;
  const auto gt = [](s64 a, s64 b) { return a > b; };
  const auto lt = [](s64 a, s64 b) { return a < b; };
  const auto ge = [](s64 a, s64 b) { return a >= b; };
  const auto le = [](s64 a, s64 b) { return a <= b; };
  check_predicate<V>(
      "vec_all_nge", [](V a, V b) { return vec_all_nge(a, b); }, all_of<V>(lt));
  check_predicate<V>(
      "vec_all_ngt", [](V a, V b) { return vec_all_ngt(a, b); }, all_of<V>(le));
  check_predicate<V>(
      "vec_all_nle", [](V a, V b) { return vec_all_nle(a, b); }, all_of<V>(gt));
  check_predicate<V>(
      "vec_all_nlt", [](V a, V b) { return vec_all_nlt(a, b); }, all_of<V>(ge));
  check_predicate<V>(
      "vec_any_nge", [](V a, V b) { return vec_any_nge(a, b); }, any_of<V>(lt));
  check_predicate<V>(
      "vec_any_ngt", [](V a, V b) { return vec_any_ngt(a, b); }, any_of<V>(le));
  check_predicate<V>(
      "vec_any_nle", [](V a, V b) { return vec_any_nle(a, b); }, any_of<V>(gt));
  check_predicate<V>(
      "vec_any_nlt", [](V a, V b) { return vec_any_nlt(a, b); }, any_of<V>(ge));
}

int count_of(const Register& a, bool (*holds)(u64 word)) {
  int n = 0;
  for (int i = 0; i < 4; ++i) n += holds(lane<4>(a, i)) ? 1 : 0;
  return n;
}

bool is_nan_pattern(u64 word) {
  return (word & 0x7fffffff) > 0x7f800000;
}
bool is_numeric(u64 word) {
  return (word & 0x7f800000) != 0x7f800000;
}

// Few random vectors have NaNs in some elements or in all, so each is also tried with some exponents set to
// 255.
TEST(VmxPredicates, FindNansByTheirBits) {
  using V = vec_float4;
  const auto check_question = [](const char* name, auto intrinsic, auto ref) {
    const vec_uint4 infinity = spu_splats(0x7f800000U);
    for (const vec_uint4 set : {vec_uint4{}, vec_uint4{0, 0, 0x7f800000U, 0}, infinity}) {
      check<V>(
          name, [=](V a) { return intrinsic((V)((vec_uint4)a | set)); },
          [=](const Register& a) {
            return ref(lanewise<4>([](u64 x, u64 y) { return x | y; })(a, image(set)));
          });
    }
  };
  check_question(
      "vec_all_nan", [](V a) { return vec_all_nan(a); }, [](const Register&) { return 0; });
  check_question(
      "vec_any_nan", [](V a) { return vec_any_nan(a); },
      [](const Register& a) { return count_of(a, is_nan_pattern) > 0 ? 1 : 0; });
  check_question(
      "vec_all_numeric", [](V a) { return vec_all_numeric(a); },
      [](const Register& a) { return count_of(a, is_numeric) == 4 ? 1 : 0; });
  check_question(
      "vec_any_numeric", [](V a) { return vec_any_numeric(a); },
      [](const Register& a) { return count_of(a, is_numeric) > 0 ? 1 : 0; });
}

Register bounds(const Register& a, const Register& b) {
  return build<4>([&](int i) {
    const s64 x = key<vec_float4>(a, i);
    const s64 limit = key<vec_float4>(b, i);
    return (x > limit ? 0x80000000U : 0U) | (x < -limit ? 0x40000000U : 0U);
  });
}

// A bound with the sign bit, -0 included, has nothing within it.
bool all_within(const Register& a, const Register& b) {
  bool all = true;
  for (int i = 0; i < 4; ++i) {
    const s64 x = key<vec_float4>(a, i);
    all = all && lane<4>(b, i) >> 31 == 0 && (x < 0 ? -x : x) <= key<vec_float4>(b, i);
  }
  return all;
}

TEST(VmxCompare, ComparesFloatsAndBounds) {
  using V = vec_float4;
  const spu_emu::SpuFloatMode mode;
  const auto comparison = [](auto f) {
    return [f](const Register& a, const Register& b) {
      return build<4>([&](int i) { return all_ones(f(key<V>(a, i), key<V>(b, i))); });
    };
  };
  check<V, V>(
      "vec_cmpge", [](V a, V b) { return vec_cmpge(a, b); }, comparison([](s64 a, s64 b) { return a >= b; }));
  check<V, V>(
      "vec_cmple", [](V a, V b) { return vec_cmple(a, b); }, comparison([](s64 a, s64 b) { return a <= b; }));
  check<V, V>(
      "vec_cmplt", [](V a, V b) { return vec_cmplt(a, b); }, comparison([](s64 a, s64 b) { return a < b; }));
  check<V, V>(
      "vec_cmpgt", [](V a, V b) { return vec_cmpgt(a, b); }, comparison([](s64 a, s64 b) { return a > b; }));
  check<V, V>(
      "vec_cmpeq", [](V a, V b) { return vec_cmpeq(a, b); }, comparison([](s64 a, s64 b) { return a == b; }));
  check<V, V>(
      "vec_cmpb", [](V a, V b) { return vec_cmpb(a, b); }, bounds);
  check<V, V>(
      "vec_all_in", [](V a, V b) { return vec_all_in(a, b); },
      [](const Register& a, const Register& b) { return all_within(a, b) ? 1 : 0; });
  check<V, V>(
      "vec_any_out", [](V a, V b) { return vec_any_out(a, b); },
      [](const Register& a, const Register& b) { return all_within(a, b) ? 0 : 1; });
  EXPECT_EQ(vec_all_in(V{}, V{}), 1);
  EXPECT_EQ(vec_all_in(V{}, V{0, 0, -0.0F, 0}), 0);
  EXPECT_EQ(vec_any_out(V{}, V{0, 0, -0.0F, 0}), 1);
}

}  // namespace
