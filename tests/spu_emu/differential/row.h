// One intrinsic called on quadwords of 32-bit words, in source that both SPU compilers take.
#pragma once

#include <spu_intrinsics.h>
#include <vmx2spu.h>

#include <type_traits>

// In front of a template's function the SDK's macro for the type would lose its vector.
using Words = vec_uint4;

// Arguments come from four quadwords, the result is one. A scalar is the first words of a quadword.
using Row = vec_uint4 (*)(const vec_uint4* in);
extern const Row rows[];
extern const unsigned row_count;

template <class V>
V as_vector(vec_uint4 words) {
  return (V)(qword)words;
}

// The SDK's own names are macros there, which do not take template arguments: so vectors get names first.
template <class T>
T scalar(vec_uint4 words) {
  if constexpr (std::is_same_v<T, float>) {
    const auto floats = as_vector<vec_float4>(words);
    return spu_extract(floats, 0);
  } else if constexpr (std::is_same_v<T, double>) {
    const auto doubles = as_vector<vec_double2>(words);
    return spu_extract(doubles, 0);
  } else if constexpr (sizeof(T) == 8) {
    const auto numbers = as_vector<vec_ullong2>(words);
    return static_cast<T>(spu_extract(numbers, 0));
  } else {
    return static_cast<T>(spu_extract(words, 0));
  }
}

template <class T>
Words words(T value) {
  if constexpr (std::is_same_v<T, float>) {
    const vec_float4 vector_of_one = {value, 0, 0, 0};
    return (vec_uint4)(qword)vector_of_one;
  } else if constexpr (std::is_same_v<T, double>) {
    const vec_double2 vector_of_one = {value, 0};
    return (vec_uint4)(qword)vector_of_one;
  } else if constexpr (std::is_arithmetic_v<T> && sizeof(T) == 8) {
    const vec_ullong2 vector_of_one = {static_cast<unsigned long long>(value), 0};
    return (vec_uint4)(qword)vector_of_one;
  } else if constexpr (std::is_arithmetic_v<T>) {
    const vec_uint4 vector_of_one = {static_cast<unsigned int>(value), 0, 0, 0};
    return vector_of_one;
  } else {
    return (vec_uint4)(qword)value;
  }
}

// The vector type with elements of type T; a vector type itself.
template <class T>
struct VectorOf {
  using Type = T;
  static constexpr int element_bytes = 16;
};
#define ELEMENT_OF(element, vector_type)                  \
  template <>                                             \
  struct VectorOf<element> {                              \
    using Type = vector_type;                             \
    static constexpr int element_bytes = sizeof(element); \
  };
ELEMENT_OF(unsigned char, vec_uchar16)
ELEMENT_OF(signed char, vec_char16)
ELEMENT_OF(unsigned short, vec_ushort8)
ELEMENT_OF(short, vec_short8)
ELEMENT_OF(unsigned int, vec_uint4)
ELEMENT_OF(int, vec_int4)
ELEMENT_OF(float, vec_float4)
#undef ELEMENT_OF

// Three quadwords of memory for loads and stores; elements are what both engines number alike.
template <class T>
class Memory {
 public:
  using V = typename VectorOf<T>::Type;
  explicit Memory(const vec_uint4* in)
      : vectors_{as_vector<V>(in[0]), as_vector<V>(in[1]), as_vector<V>(in[0])} {}
  T* data() { return reinterpret_cast<T*>(vectors_); }
  // Everything in it, folded word by word.
  Words words() const {
    const vec_uint4 first = (vec_uint4)(qword)vectors_[0];
    const vec_uint4 second = (vec_uint4)(qword)vectors_[1];
    const vec_uint4 third = (vec_uint4)(qword)vectors_[2];
    return spu_xor(first, spu_xor(spu_rl(second, 5), spu_rl(third, 11)));
  }

 private:
  V vectors_[3] __attribute__((aligned(16)));
};

// A byte offset below 32 that is a multiple of the element's size.
template <class T>
int offset(vec_uint4 words) {
  return static_cast<int>(spu_extract(words, 0) % 32) / VectorOf<T>::element_bytes *
         VectorOf<T>::element_bytes;
}
