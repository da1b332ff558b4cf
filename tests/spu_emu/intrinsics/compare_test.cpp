#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

// Sign-extended or not, as the element type says.
template <typename V, typename F>
auto comparison(F f) {
  return [f](const Register& a, const Register& b) {
    constexpr int width = width_of<V>;
    return build<width>([&](int i) {
      if constexpr (std::is_signed_v<ElementOf<V>>)
        return all_ones(f(signed_lane<width>(a, i), signed_lane<width>(b, i)));
      else
        return all_ones(f(lane<width>(a, i), lane<width>(b, i)));
    });
  };
}

TEST(IntegerCompare, SetsAllBitsOfElementsThatCompareTrue) {
  for_integer_types([](auto type) {
    using V = TYPE_OF(type);
    using E = ElementOf<V>;
    constexpr int width = width_of<V>;
    const auto equal = comparison<V>([](auto a, auto b) { return a == b; });
    const auto greater = comparison<V>([](auto a, auto b) { return a > b; });
    check<V, V>(
        "spu_cmpeq", [](V a, V b) { return spu_cmpeq(a, b); }, equal);
    check<V, E>(
        "spu_cmpeq scalar", [](V a, E b) { return spu_cmpeq(a, b); }, with_splat<width>(equal));
    check<V, V>(
        "spu_cmpgt", [](V a, V b) { return spu_cmpgt(a, b); }, greater);
    check<V, E>(
        "spu_cmpgt scalar", [](V a, E b) { return spu_cmpgt(a, b); }, with_splat<width>(greater));
  });
}

}  // namespace
