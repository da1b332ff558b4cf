// Runs an intrinsic against its scalar reference: combinations of edge values, then 10,000 seeded random
// inputs, or fewer in a build with sanitizers.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <utility>

#include "register_image.h"

namespace reference {

// One argument or result: the image of a register, or a scalar as its bits.
struct Value {
  bool is_scalar = false;
  std::uint64_t scalar = 0;
  Register image{};
};

bool operator==(const Value& a, const Value& b);

// A function of arguments, called by reference: a std::function for each of a thousand checks takes minutes
// to compile.
struct Function {
  const void* callable;
  Value (*call)(const void* callable, const Value* arguments);

  Value operator()(const Value* arguments) const { return call(callable, arguments); }
};

using Agreement = bool (*)(const Value& result, const Value& expected, const Value* arguments);

// Draws arguments of the kinds named (true: a scalar) and reports the first on which the functions disagree.
void run_check(const char* name, std::initializer_list<bool> scalar_arguments, Function intrinsic,
               Function ref, Agreement agree);

template <typename T>
constexpr bool is_scalar_type = std::is_arithmetic_v<T>;

template <typename T>
Value to_value(const T& t) {
  Value v;
  if constexpr (std::is_same_v<T, Register>) {
    v.image = t;
  } else if constexpr (is_scalar_type<T>) {
    v.is_scalar = true;
    std::memcpy(&v.scalar, &t, sizeof t);
  } else {
    v.image = image(t);
  }
  return v;
}

template <typename T>
T from_value(const Value& v) {
  if constexpr (is_scalar_type<T>) {
    T t;
    std::memcpy(&t, &v.scalar, sizeof t);
    return t;
  } else {
    return vector<T>(v.image);
  }
}

// What a reference gets for an argument of type T: an image or the scalar.
template <typename T>
auto for_reference(const Value& v) {
  if constexpr (is_scalar_type<T>)
    return from_value<T>(v);
  else
    return v.image;
}

// A reference may compute in a wider integer than the intrinsic returns.
template <typename Result, typename T>
Value as_result(const T& expected) {
  if constexpr (is_scalar_type<Result>)
    return to_value(static_cast<Result>(expected));
  else
    return to_value(expected);
}

template <typename... Args, std::size_t... I, typename Intrinsic, typename Ref>
void check_with(std::index_sequence<I...>, const char* name, const Intrinsic& intrinsic, const Ref& ref,
                Agreement agree) {
  using Result = decltype(intrinsic(from_value<Args>(Value{})...));
  run_check(name, {is_scalar_type<Args>...},
            {&intrinsic,
             [](const void* callable, const Value* a) {
               return to_value((*static_cast<const Intrinsic*>(callable))(from_value<Args>(a[I])...));
             }},
            {&ref,
             [](const void* callable, const Value* a) {
               return as_result<Result>((*static_cast<const Ref*>(callable))(for_reference<Args>(a[I])...));
             }},
            agree);
}

bool same_bits(const Value& result, const Value& expected, const Value* arguments);

// check<argument types...>(name, intrinsic, reference): the reference takes images and scalars and returns
// one.
template <typename... Args, typename Intrinsic, typename Ref>
void check(const char* name, Intrinsic intrinsic, Ref ref, Agreement agree = same_bits) {
  check_with<Args...>(std::index_sequence_for<Args...>{}, name, intrinsic, ref, agree);
}

// Calls f with a null pointer of each type, to name the type.
template <typename... V, typename F>
void for_types(F f) {
  (f(static_cast<V*>(nullptr)), ...);
}

template <typename F>
void for_integer_types(F f) {
  for_types<vec_uchar16, vec_char16, vec_ushort8, vec_short8, vec_uint4, vec_int4>(f);
}

template <typename F>
void for_all_types(F f) {
  for_types<vec_uchar16, vec_char16, vec_ushort8, vec_short8, vec_uint4, vec_int4, vec_ullong2, vec_llong2,
            vec_float4, vec_double2>(f);
}

template <typename V>
using ElementOf = std::remove_cv_t<std::remove_reference_t<decltype(std::declval<V&>()[0])>>;

template <typename V>
constexpr int width_of = static_cast<int>(sizeof(ElementOf<V>));

}  // namespace reference

// The vector type that a callback of for_types was called for.
#define TYPE_OF(pointer) std::remove_pointer_t<decltype(pointer)>
