// Double precision: IEEE results in each slot's rounding mode, denormal operands taken for zero, and the
// flags of the FPSCR; also the register itself.
#include <bit>
#include <cmath>

#include "isa/core/handlers.h"
#include "isa/core/rounded.h"
#include "spu_emu/intrinsics/specific_float.h"

namespace spu_emu::isa {

namespace {

// Further flags of a slot, beside those that arithmetic raises.
constexpr std::uint32_t kNan = 1U << 9U;
constexpr std::uint32_t kDenormal = 1U << 8U;

constexpr std::uint64_t kExponent = 0x7ff0000000000000;
constexpr std::uint64_t kSign = 0x8000000000000000;
constexpr std::uint64_t kQuiet = 0x0008000000000000;
constexpr std::uint64_t kDefaultNan = 0x7ff8000000000000;
constexpr std::uint32_t kDefaultNanSingle = 0x7fc00000;

/// The bits of the FPSCR that exist.
constexpr vec_uint4 kFpscrMask = {0xf07, 0x3f07, 0x3f07, 0xf07};

bool is_nan(std::uint64_t bits) {
  return (bits & ~kSign) > kExponent;
}

/// Rounding mode of a slot, as fscrwr set it.
unsigned rounding(const State& state, int slot) {
  return (state.fpscr[0] >> (slot == 0 ? 10U : 8U)) & 3U;
}

/// Takes denormals for zeros of their sign, and collects flags; true if there is a NaN.
template <std::size_t Count>
bool prepare(std::uint64_t (&operands)[Count], std::uint32_t& flags) {
  bool has_nan = false;
  for (std::uint64_t& bits : operands) {
    if ((bits & kExponent) == 0 && (bits & ~kSign) != 0) {
      flags |= kDenormal;
      bits &= kSign;
    }
    if (is_nan(bits)) {
      has_nan = true;
      flags |= kNan | ((bits & kQuiet) == 0 ? kInvalid : 0U);
    }
  }
  return has_nan;
}

__m128d add(__m128d a, __m128d b, __m128d) {
  return _mm_add_sd(a, b);
}
__m128d subtract(__m128d a, __m128d b, __m128d) {
  return _mm_sub_sd(a, b);
}
__m128d multiply(__m128d a, __m128d b, __m128d) {
  return _mm_mul_sd(a, b);
}
/// The C library's function rounds once by the mode and raises the right flags on every machine.
__m128d multiply_add(__m128d a, __m128d b, __m128d c) {
  return _mm_set_sd(std::fma(_mm_cvtsd_f64(a), _mm_cvtsd_f64(b), _mm_cvtsd_f64(c)));
}
/// The single in the low word.
__m128d narrow(__m128d a, __m128d, __m128d) {
  return as_vector(std::bit_cast<std::uint32_t>(static_cast<float>(_mm_cvtpd_ps(a)[0])));
}

std::uint64_t slot_of(qword q, int slot) {
  return static_cast<vec_ullong2>(q)[slot];
}

/// A slot's result, of registers that nothing has written yet; flags are ORed in.
using Slot = std::uint64_t (*)(const State& state, const Op* op, int slot, std::uint32_t& flags);

/// Apart from its handler, whose frame has to be gone when it calls the next one.
template <Slot F>
[[gnu::noinline]] void compute_slots(State& state, const Op* op) {
  vec_ullong2 bits{};
  for (int slot = 0; slot < 2; ++slot) {
    std::uint32_t flags = 0;
    bits[slot] = F(state, op, slot, flags);
    state.fpscr[slot + 1] |= flags;
  }
  state.at(op->t) = static_cast<qword>(bits);
}

template <Slot F>
const Op* slotwise(State& state, const Op* op) {
  compute_slots<F>(state, op);
  return go_on(state, op);
}

template <auto Operation>
std::uint64_t arithmetic(const State& state, const Op* op, int slot, std::uint32_t& flags) {
  std::uint64_t operands[3] = {slot_of(state.at(op->a), slot), slot_of(state.at(op->b), slot), 0};
  if (prepare(operands, flags)) return kDefaultNan;
  const std::uint64_t bits = rounded(Operation, rounding(state, slot), operands, flags);
  return is_nan(bits) ? kDefaultNan : bits;
}

/// a * b + t with the signs of t and of the rounded result as the instruction has them.
template <std::uint64_t AddendSign, std::uint64_t ResultSign>
std::uint64_t fused(const State& state, const Op* op, int slot, std::uint32_t& flags) {
  std::uint64_t operands[3] = {slot_of(state.at(op->a), slot), slot_of(state.at(op->b), slot),
                               slot_of(state.at(op->t), slot) ^ AddendSign};
  if (prepare(operands, flags)) return kDefaultNan;
  const std::uint64_t bits = rounded(multiply_add, rounding(state, slot), operands, flags);
  return is_nan(bits) ? kDefaultNan : bits ^ ResultSign;
}

/// The single stands in the left word of the double's slot.
std::uint64_t extend(const State& state, const Op* op, int slot, std::uint32_t& flags) {
  const auto single = static_cast<std::uint32_t>(slot_of(state.at(op->a), slot) >> 32U);
  const std::uint32_t magnitude = single & 0x7fffffffU;
  if (magnitude > 0x7f800000U) {
    flags |= kNan | ((single & 0x00400000U) == 0 ? kInvalid : 0U);
    return kDefaultNan;
  }
  const std::uint64_t sign = std::uint64_t{single & 0x80000000U} << 32U;
  if (magnitude < 0x00800000U) {
    if (magnitude != 0) flags |= kDenormal;
    return sign;
  }
  if (magnitude == 0x7f800000U) return sign | kExponent;
  return sign | ((std::uint64_t{magnitude} << 29U) + (std::uint64_t{1023 - 127} << 52U));
}

std::uint64_t round_to_single(const State& state, const Op* op, int slot, std::uint32_t& flags) {
  std::uint64_t operands[3] = {slot_of(state.at(op->a), slot), 0, 0};
  if (prepare(operands, flags)) return std::uint64_t{kDefaultNanSingle} << 32U;
  return rounded(narrow, rounding(state, slot), operands, flags) << 32U;
}

/// Compares leave the flags of their operands, too.
template <qword (*F)(qword, qword)>
std::uint64_t compare(const State& state, const Op* op, int slot, std::uint32_t& flags) {
  std::uint64_t operands[2] = {slot_of(state.at(op->a), slot), slot_of(state.at(op->b), slot)};
  prepare(operands, flags);
  return slot_of(F(state.at(op->a), state.at(op->b)), slot);
}

const Op* read_fpscr(State& state, const Op* op) {
  state.at(op->t) = static_cast<qword>(state.fpscr);
  return go_on(state, op);
}

const Op* write_fpscr(State& state, const Op* op) {
  state.fpscr = static_cast<vec_uint4>(state.at(op->a)) & kFpscrMask;
  return go_on(state, op);
}

constexpr HandlerRow kRows[] = {
    {"dfa", slotwise<arithmetic<add>>},
    {"dfs", slotwise<arithmetic<subtract>>},
    {"dfm", slotwise<arithmetic<multiply>>},
    {"dfma", slotwise<fused<0, 0>>},
    {"dfms", slotwise<fused<kSign, 0>>},
    {"dfnms", slotwise<fused<kSign, kSign>>},
    {"dfnma", slotwise<fused<0, kSign>>},
    {"dfceq", slotwise<compare<si_dfceq>>},
    {"dfcmeq", slotwise<compare<si_dfcmeq>>},
    {"dfcgt", slotwise<compare<si_dfcgt>>},
    {"dfcmgt", slotwise<compare<si_dfcmgt>>},
    {"dftsv", with_immediate<si_dftsv>},
    {"fesd", slotwise<extend>},
    {"frds", slotwise<round_to_single>},
    {"fscrrd", read_fpscr},
    {"fscrwr", write_fpscr},
};

}  // namespace

std::span<const HandlerRow> float_double_handlers() {
  return kRows;
}

}  // namespace spu_emu::isa
