#include "isa/core/float_single.h"

#include "isa/core/handlers.h"
#include "spu_emu/intrinsics/specific_float.h"

namespace spu_emu::isa {

namespace {

using detail::WideFloat;

__m128i words(vec_float4 v) {
  return (__m128i)v;
}

__m128i magnitude_of(vec_float4 v) {
  return _mm_and_si128(words(v), _mm_set1_epi32(INT32_MAX));
}

/// Where the exponent is 255.
__m128i is_extended(vec_float4 v) {
  return _mm_cmpgt_epi32(magnitude_of(v), _mm_set1_epi32(0x7f7fffff));
}

/// Where IEEE arithmetic takes the operand for something else: exponent 255, or a denormal.
__m128i is_unusual(vec_float4 v) {
  const __m128i magnitude = magnitude_of(v);
  const __m128i small = _mm_cmpgt_epi32(_mm_set1_epi32(detail::least_normal_float), magnitude);
  const __m128i denormal = _mm_andnot_si128(_mm_cmpeq_epi32(magnitude, _mm_setzero_si128()), small);
  return _mm_or_si128(denormal, is_extended(v));
}

/// Narrows an exact or truncated result, and finds the flags that operands and result ask for.
SingleResult finish(WideFloat wide, __m128i unusual) {
  const __m128i high = _mm_and_si128(detail::high_words(wide), _mm_set1_epi32(INT32_MAX));
  const __m128i is_zero = _mm_cmpeq_epi32(_mm_or_si128(high, detail::low_words(wide)), _mm_setzero_si128());
  const __m128i least = _mm_set1_epi32(detail::exponent_shift_in_high_word + (1 << 20));
  const __m128i largest = _mm_set1_epi32(detail::exponent_shift_in_high_word + (256 << 20) - 1);
  const __m128i underflow = _mm_andnot_si128(is_zero, _mm_cmpgt_epi32(least, high));
  const __m128i overflow = _mm_cmpgt_epi32(high, largest);
  const vec_float4 value = detail::narrow(wide);
  const __m128i different = _mm_or_si128(_mm_or_si128(unusual, underflow), is_extended(value));
  const __m128i flags = _mm_or_si128(_mm_and_si128(overflow, _mm_set1_epi32(kOverflow)),
                                     _mm_or_si128(_mm_and_si128(underflow, _mm_set1_epi32(kUnderflow)),
                                                  _mm_and_si128(different, _mm_set1_epi32(kDifferent))));
  return {value, (vec_uint4)flags};
}

__m128i either_unusual(vec_float4 a, vec_float4 b) {
  return _mm_or_si128(is_unusual(a), is_unusual(b));
}

/// Whether all slots of all registers hold numbers from 2^-126 to below 2^127: if operands and result of the
/// host's arithmetic do, then the result is the SPU's, and leaves no flag.
template <class... Registers>
bool are_ordinary(Registers... registers) {
  const __m128i least = _mm_set1_epi32(detail::least_normal_float);
  const __m128i limit = _mm_set1_epi32(0x7f000000 - detail::least_normal_float - 1);
  __m128i largest = limit;
  ((largest = _mm_max_epu32(largest, _mm_sub_epi32(magnitude_of(static_cast<vec_float4>(registers)), least))),
   ...);
  return _mm_movemask_epi8(_mm_cmpeq_epi32(largest, limit)) == 0xffff;
}

// These are apart from the handlers, whose frames have to be gone when they call the next one.

template <auto Exact>
[[gnu::noinline]] void compute_binary(State& state, const Op* op) {
  const SingleResult result =
      Exact(static_cast<vec_float4>(state.at(op->a)), static_cast<vec_float4>(state.at(op->b)));
  state.fpscr |= result.flags;
  state.at(op->t) = static_cast<qword>(result.value);
}

template <auto Exact>
[[gnu::noinline]] void compute_ternary(State& state, const Op* op) {
  const SingleResult result =
      Exact(static_cast<vec_float4>(state.at(op->a)), static_cast<vec_float4>(state.at(op->b)),
            static_cast<vec_float4>(state.at(op->t)));
  state.fpscr |= result.flags;
  state.at(op->c) = static_cast<qword>(result.value);
}

/// By the host's arithmetic where that is exact.
template <auto Host, auto Exact>
const Op* binary_single(State& state, const Op* op) {
  const qword a = state.at(op->a);
  const qword b = state.at(op->b);
  const qword result = Host(a, b);
  if (are_ordinary(a, b, result)) [[likely]]
    state.at(op->t) = result;
  else
    compute_binary<Exact>(state, op);
  return go_on(state, op);
}

template <auto Host, auto Exact>
const Op* ternary_single(State& state, const Op* op) {
  const qword a = state.at(op->a);
  const qword b = state.at(op->b);
  const qword t = state.at(op->t);
  const qword result = Host(a, b, t);
  if (are_ordinary(a, b, t, result)) [[likely]]
    state.at(op->c) = result;
  else
    compute_ternary<Exact>(state, op);
  return go_on(state, op);
}

/// a * b - c
SingleResult multiply_subtract(vec_float4 a, vec_float4 b, vec_float4 c) {
  return multiply_add_single(a, b, detail::negate(c));
}

/// c - a * b
SingleResult negative_multiply_subtract(vec_float4 a, vec_float4 b, vec_float4 c) {
  return multiply_add_single(detail::negate(a), b, c);
}

/// The flag of a division by zero: a bit for each slot in the last word, slot 0's the leftmost.
vec_uint4 division_by_zero(vec_float4 v) {
  constexpr unsigned kFirstSlot = 0x800;
  const vec_uint4 exponent = ((vec_uint4)v >> 23) & 255U;
  unsigned flags = 0;
  for (int slot = 0; slot < 4; ++slot)
    if (exponent[slot] == 0) flags |= kFirstSlot >> slot;
  return vec_uint4{0, 0, 0, flags};
}

template <auto F>
const Op* estimate(State& state, const Op* op) {
  const qword argument = state.at(op->a);
  state.fpscr |= division_by_zero(static_cast<vec_float4>(argument));
  state.at(op->t) = F(argument);
  return go_on(state, op);
}

constexpr HandlerRow kRows[] = {
    {"fa", binary_single<si_fa, add_single>},
    {"fs", binary_single<si_fs, subtract_single>},
    {"fm", binary_single<si_fm, multiply_single>},
    {"fma", ternary_single<si_fma, multiply_add_single>},
    {"fms", ternary_single<si_fms, multiply_subtract>},
    {"fnms", ternary_single<si_fnms, negative_multiply_subtract>},
    {"fceq", binary<si_fceq>},
    {"fcmeq", binary<si_fcmeq>},
    {"fcgt", binary<si_fcgt>},
    {"fcmgt", binary<si_fcmgt>},
    {"frest", estimate<si_frest>},
    {"frsqest", estimate<si_frsqest>},
    {"fi", binary<si_fi>},
    {"cflts", with_immediate<si_cflts>},
    {"cfltu", with_immediate<si_cfltu>},
    {"csflt", with_immediate<si_csflt>},
    {"cuflt", with_immediate<si_cuflt>},
};

}  // namespace

SingleResult add_single(vec_float4 a, vec_float4 b) {
  const WideFloat x = detail::widen(a);
  const WideFloat y = detail::widen(b);
  return finish({_mm_add_pd(x.low, y.low), _mm_add_pd(x.high, y.high)}, either_unusual(a, b));
}

SingleResult subtract_single(vec_float4 a, vec_float4 b) {
  return add_single(a, detail::negate(b));
}

SingleResult multiply_single(vec_float4 a, vec_float4 b) {
  const WideFloat x = detail::widen(a);
  const WideFloat y = detail::widen(b);
  return finish({_mm_mul_pd(x.low, y.low), _mm_mul_pd(x.high, y.high)}, either_unusual(a, b));
}

SingleResult multiply_add_single(vec_float4 a, vec_float4 b, vec_float4 c) {
  const WideFloat x = detail::widen(a);
  const WideFloat y = detail::widen(b);
  const WideFloat z = detail::widen(c);
  const WideFloat sum = {_mm_add_pd(_mm_mul_pd(x.low, y.low), z.low),
                         _mm_add_pd(_mm_mul_pd(x.high, y.high), z.high)};
  return finish(sum, _mm_or_si128(either_unusual(a, b), is_unusual(c)));
}

std::span<const HandlerRow> float_single_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
