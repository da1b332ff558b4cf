// Every function of the SIMD math library by its number, on registers as four words, the leftmost first: the
// same for the host engine, the real SPU and the PPU.
#pragma once

#include <simdmath.h>

namespace simdmath_test {

// Of each source that includes this its own: the host engine's comes in two builds.
namespace {

struct Register {
  vec_uint4 words;
};

#ifdef __SPU__
template <typename V>
V load(const Register& r) {
  return (V)(qword)r.words;
}
template <typename V>
void store(V v, Register* r) {
  r->words = (vec_uint4)(qword)v;
}
#else
template <typename V>
V load(const Register& r) {
  return (V)r.words;
}
template <typename V>
void store(V v, Register* r) {
  r->words = (vec_uint4)v;
}
#endif
inline void store(llroundf4_t v, Register* r) {
  store(v.vll[0], r);
  store(v.vll[1], r + 1);
}
inline void store(lldivi2_t v, Register* r) {
  store(v.quot, r);
  store(v.rem, r + 1);
}
inline void store(lldivu2_t v, Register* r) {
  store(v.quot, r);
  store(v.rem, r + 1);
}
inline void store(divi4_t v, Register* r) {
  store(v.quot, r);
  store(v.rem, r + 1);
}
inline void store(divu4_t v, Register* r) {
  store(v.quot, r);
  store(v.rem, r + 1);
}

constexpr unsigned kArguments = 3;
constexpr unsigned kResults = 2;

// Reads kArguments registers and writes kResults; what a function does not return stays as it was.
using Evaluator = void (*)(const Register* in, Register* out);

#define SM_1(header, result, name, A)                       \
  void evaluate_##name(const Register* in, Register* out) { \
    store(name(load<A>(in[0])), out);                       \
  }
#define SM_2(header, result, name, A, B)                    \
  void evaluate_##name(const Register* in, Register* out) { \
    store(name(load<A>(in[0]), load<B>(in[1])), out);       \
  }
#define SM_3(header, result, name, A, B, C)                           \
  void evaluate_##name(const Register* in, Register* out) {           \
    store(name(load<A>(in[0]), load<B>(in[1]), load<C>(in[2])), out); \
  }
#define SM_1P(header, result, name, A, P)                   \
  void evaluate_##name(const Register* in, Register* out) { \
    P second;                                               \
    store(name(load<A>(in[0]), &second), out);              \
    store(second, out + 1);                                 \
  }
#define SM_2P(header, result, name, A, B, P)                   \
  void evaluate_##name(const Register* in, Register* out) {    \
    P second;                                                  \
    store(name(load<A>(in[0]), load<B>(in[1]), &second), out); \
    store(second, out + 1);                                    \
  }
#define SM_PP(header, name, A)                              \
  void evaluate_##name(const Register* in, Register* out) { \
    A first;                                                \
    A second;                                               \
    name(load<A>(in[0]), &first, &second);                  \
    store(first, out);                                      \
    store(second, out + 1);                                 \
  }
#include <simdmath/functions.def>
#undef SM_1
#undef SM_2
#undef SM_3
#undef SM_1P
#undef SM_2P
#undef SM_PP

#define SM_1(header, result, name, A) evaluate_##name,
#define SM_2(header, result, name, A, B) evaluate_##name,
#define SM_3(header, result, name, A, B, C) evaluate_##name,
#define SM_1P(header, result, name, A, P) evaluate_##name,
#define SM_2P(header, result, name, A, B, P) evaluate_##name,
#define SM_PP(header, name, A) evaluate_##name,
const Evaluator evaluators[] = {
#include <simdmath/functions.def>
};
#undef SM_1
#undef SM_2
#undef SM_3
#undef SM_1P
#undef SM_2P
#undef SM_PP

}  // namespace

}  // namespace simdmath_test
