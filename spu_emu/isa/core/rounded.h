/// @file
/// One double-precision operation in a rounding mode, and the flags that it raises.
#ifndef SPU_EMU_ISA_CORE_ROUNDED_H
#define SPU_EMU_ISA_CORE_ROUNDED_H

#include <cstdint>

#include "spu_emu/intrinsics/double.h"
#include "spu_emu/intrinsics/float_mode.h"

namespace spu_emu::isa {

// Flags of a slot, in the word of the FPSCR after that of the slot's number.
constexpr std::uint32_t kOverflow = 1U << 13U;
constexpr std::uint32_t kUnderflow = 1U << 12U;
constexpr std::uint32_t kInexact = 1U << 11U;
constexpr std::uint32_t kInvalid = 1U << 10U;

inline __m128d as_vector(std::uint64_t bits) {
  return _mm_castsi128_pd(_mm_set_epi64x(0, static_cast<std::int64_t>(bits)));
}

inline std::uint64_t low_bits(__m128d v) {
  return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_castpd_si128(v)));
}

/// What the operation had to say, as the processor's flags name it.
constexpr std::uint32_t flags_of(bool invalid, bool overflow, bool underflow, bool inexact) {
  if (invalid) return kInvalid;
  return (overflow ? kOverflow : 0U) | (underflow ? kUnderflow : 0U) | (inexact ? kInexact : 0U);
}

/// operation(a, b, c) on scalars in the FPSCR's rounding mode `mode`. Operands and result pass through the
/// changes of mode, which keeps the compiler from moving the operation out of them. Leaves the SPU's mode
/// behind.
template <class Operation>
std::uint64_t rounded(Operation operation, unsigned mode, const std::uint64_t (&operands)[3],
                      std::uint32_t& flags) {
  __m128d a = as_vector(operands[0]);
  __m128d b = as_vector(operands[1]);
  __m128d c = as_vector(operands[2]);
#ifdef __SSE4_1__
  detail::load_mxcsr(detail::double_mxcsr(mode), a, b, c);
  __m128d result = operation(a, b, c);
  unsigned mxcsr = 0;
  asm volatile("stmxcsr %1" : "+x"(result), "=m"(mxcsr));
  detail::load_mxcsr(spu_mxcsr, result);
  flags |= flags_of((mxcsr & _MM_EXCEPT_INVALID) != 0, (mxcsr & _MM_EXCEPT_OVERFLOW) != 0,
                    (mxcsr & _MM_EXCEPT_UNDERFLOW) != 0, (mxcsr & _MM_EXCEPT_INEXACT) != 0);
#else
  std::feclearexcept(FE_ALL_EXCEPT);
  detail::set_rounding(detail::double_rounding_mode(mode), a, b, c);
  __m128d result = operation(a, b, c);
  detail::set_rounding(spu_float_control, result);
  flags |= flags_of(std::fetestexcept(FE_INVALID) != 0, std::fetestexcept(FE_OVERFLOW) != 0,
                    std::fetestexcept(FE_UNDERFLOW) != 0, std::fetestexcept(FE_INEXACT) != 0);
#endif
  return low_bits(result);
}

}  // namespace spu_emu::isa

#endif
