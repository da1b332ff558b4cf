// Double-precision instructions against exact arithmetic in all rounding modes, their flags too.
#include "../../intrinsics/exact.h"
#include "reference_check.h"

namespace spu_emu::isa {
namespace {

using namespace reference;

constexpr u64 kDoubleSign = 0x8000000000000000;
constexpr u64 kInfinity = 0x7ff0000000000000;
constexpr Rounding kModes[] = {Rounding::nearest, Rounding::toward_zero, Rounding::up, Rounding::down};

u64 negated(u64 bits) {
  return is_nan(bits) ? bits : bits ^ kDoubleSign;
}

/// For both slots, each in its own rounding mode: f(mode, lanes...).
template <class F>
auto in_modes(unsigned first, unsigned second, F f) {
  return [=](const Register& a, const auto&... more) {
    return build<8>(
        [&](int i) { return f(kModes[i == 0 ? first : second], lane<8>(a, i), lane<8>(more, i)...); });
  };
}

void check_arithmetic(unsigned first, unsigned second) {
  ReferenceCheck spu(first << 10 | second << 8);
  const auto two = [&](auto f) { return of_ab(in_modes(first, second, f)); };
  const auto three = [&](auto f) { return of_abt(in_modes(first, second, f)); };
  spu.check("dfa", two([](Rounding m, u64 a, u64 b) { return spu_double_add(a, b, m); }));
  spu.check("dfs", two([](Rounding m, u64 a, u64 b) { return spu_double_add(a, b ^ kDoubleSign, m); }));
  spu.check("dfm", two([](Rounding m, u64 a, u64 b) { return spu_double_multiply(a, b, m); }));
  spu.check("dfma", three([](Rounding m, u64 a, u64 b, u64 t) { return spu_double_madd(a, b, t, m); }));
  spu.check("dfms",
            three([](Rounding m, u64 a, u64 b, u64 t) { return spu_double_madd(a, b, t ^ kDoubleSign, m); }));
  spu.check("dfnma",
            three([](Rounding m, u64 a, u64 b, u64 t) { return negated(spu_double_madd(a, b, t, m)); }));
  spu.check("dfnms", three([](Rounding m, u64 a, u64 b, u64 t) {
              return negated(spu_double_madd(a, b, t ^ kDoubleSign, m));
            }));
}

TEST(DoubleInstructions, RoundEachSlotByTheFpscr) {
  for (unsigned mode = 0; mode < 4; ++mode) check_arithmetic(mode, (mode + 1) % 4);
}

Term term_of(u64 bits) {
  const auto exponent = static_cast<int>(bits >> 52 & 0x7ff);
  const u64 fraction = bits & 0xfffffffffffff;
  if (exponent == 0) return {(bits & kDoubleSign) != 0, fraction, -1074};
  return {(bits & kDoubleSign) != 0, fraction | 1ULL << 52, exponent - 1075};
}

bool is_denormal(u64 bits) {
  return (bits & kInfinity) == 0 && (bits & ~kDoubleSign) != 0;
}

u64 flushed(u64 bits) {
  return is_denormal(bits) ? bits & kDoubleSign : bits;
}

/// Denormal 0x100, NaN 0x200, invalid 0x400 for a signaling one.
u64 operand_flags(u64 bits) {
  const bool signaling = is_nan(bits) && (bits & 0x8000000000000) == 0;
  return (is_denormal(bits) ? 0x100 : 0) | (is_nan(bits) ? 0x200 : 0) | (signaling ? 0x400 : 0);
}

/// Overflow 0x2000, underflow 0x1000, inexact 0x800 of a * b + t rounded to `result`, all of them finite.
u64 rounding_flags(u64 a, u64 b, u64 t, u64 result, Rounding mode) {
  ExactSum sum;
  sum.add_product(term_of(a), term_of(b));
  sum.add(term_of(t));
  if (sum.is_zero()) return 0;
  const Term unbounded = sum.rounded(53, -100000, mode);
  const int exponent = unbounded.exponent + (unbounded.mantissa >> 53 != 0 ? 1 : 0);
  if (exponent + 53 > 1024) return 0x2800;
  Term minus_result = term_of(result);
  minus_result.negative = !minus_result.negative;
  sum.add(minus_result);
  if (sum.is_zero()) return 0;
  return exponent + 53 < -1021 ? 0x1800 : 0x800;
}

u64 madd_flags(u64 a, u64 b, u64 t, Rounding mode) {
  u64 flags = operand_flags(a) | operand_flags(b) | operand_flags(t);
  if ((flags & 0x200) != 0) return flags;
  a = flushed(a);
  b = flushed(b);
  t = flushed(t);
  const u64 result = spu_double_madd(a, b, t, mode);
  if (is_nan(result)) return flags | 0x400;
  for (const u64 operand : {a, b, t})
    if ((operand & ~kDoubleSign) == kInfinity) return flags;
  return flags | rounding_flags(a, b, t, result, mode);
}

/// The FPSCR after an instruction: flags(mode, lanes...) of both slots beside the rounding modes.
template <class F>
auto fpscr_after(unsigned first, unsigned second, F flags) {
  return [=](const Register& a, const auto&... more) {
    Register r{};
    put<4>(r, 0, first << 10 | second << 8);
    put<4>(r, 1, flags(kModes[first], lane<8>(a, 0), lane<8>(more, 0)...));
    put<4>(r, 2, flags(kModes[second], lane<8>(a, 1), lane<8>(more, 1)...));
    return r;
  };
}

void check_flags(unsigned first, unsigned second) {
  constexpr u64 one = 0x3ff0000000000000;
  ReferenceCheck spu(first << 10 | second << 8);
  const auto two = [&](auto f) { return of_ab(fpscr_after(first, second, f)); };
  const auto three = [&](auto f) { return of_abt(fpscr_after(first, second, f)); };
  spu.check("dfa", two([](Rounding m, u64 a, u64 b) { return madd_flags(a, one, b, m); }), true);
  spu.check("dfs", two([](Rounding m, u64 a, u64 b) { return madd_flags(a, one, b ^ kDoubleSign, m); }),
            true);
  spu.check("dfm", two([](Rounding m, u64 a, u64 b) { return madd_flags(a, b, 0, m); }), true);
  spu.check("dfma", three([](Rounding m, u64 a, u64 b, u64 t) { return madd_flags(a, b, t, m); }), true);
  spu.check("dfnms",
            three([](Rounding m, u64 a, u64 b, u64 t) { return madd_flags(a, b, t ^ kDoubleSign, m); }),
            true);
}

TEST(DoubleInstructions, CollectTheirFlagsInTheFpscr) {
  for (unsigned mode = 0; mode < 4; ++mode) check_flags(mode, (mode + 1) % 4);
}

u64 widened(u64 word) {
  const u64 sign = word >> 31 << 63;
  const u64 exponent = word >> 23 & 255;
  const u64 fraction = word & 0x7fffff;
  if (exponent == 255) return fraction != 0 ? default_nan : sign | kInfinity;
  if (exponent == 0) return sign;
  return sign | (exponent + 896) << 52 | fraction << 29;
}

u64 narrowed(u64 bits, Rounding mode) {
  const u64 sign = bits >> 63 << 31;
  const u64 exponent = bits >> 52 & 0x7ff;
  if (is_nan(bits)) return 0x7fc00000;
  if (exponent == 0x7ff) return sign | 0x7f800000;
  if (exponent == 0) return sign;
  ExactSum sum;
  sum.add(term_of(bits));
  const Term t = sum.rounded(24, -149, mode);
  if (t.mantissa < 1 << 23) return sign | t.mantissa;
  const u64 result = (static_cast<u64>(t.exponent + 149) << 23) + t.mantissa;
  if (result < 0x7f800000) return sign | result;
  const bool to_infinity = mode == Rounding::nearest || mode == (t.negative ? Rounding::down : Rounding::up);
  return sign | (to_infinity ? 0x7f800000 : 0x7f7fffff);
}

TEST(DoubleInstructions, ConvertFromAndToSingles) {
  ReferenceCheck().check("fesd", of_a(lanewise<8>([](u64 slot) { return widened(slot >> 32); })));
  for (unsigned mode = 0; mode < 4; ++mode) {
    const unsigned other = (mode + 1) % 4;
    ReferenceCheck spu(mode << 10 | other << 8);
    spu.check("frds",
              of_a(in_modes(mode, other, [](Rounding m, u64 slot) { return narrowed(slot, m) << 32; })));
  }
}

double value_of(u64 bits) {
  double value = 0;
  bits = flushed(bits);
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

TEST(DoubleInstructions, CompareWithDenormalsAsZerosAndNoOrderForNan) {
  ReferenceCheck spu;
  spu.check("dfceq", of_ab(lanewise<8>([](u64 a, u64 b) { return all_ones(value_of(a) == value_of(b)); })));
  spu.check("dfcgt", of_ab(lanewise<8>([](u64 a, u64 b) { return all_ones(value_of(a) > value_of(b)); })));
  spu.check("dfcmeq", of_ab(lanewise<8>([](u64 a, u64 b) {
              return all_ones(value_of(a & ~kDoubleSign) == value_of(b & ~kDoubleSign));
            })));
  spu.check("dfcmgt", of_ab(lanewise<8>([](u64 a, u64 b) {
              return all_ones(value_of(a & ~kDoubleSign) > value_of(b & ~kDoubleSign));
            })));
}

/// Bit of the immediate for what a double is: NaN, infinities, zeros, denormals; the positive one first.
int kind_of(u64 bits) {
  const u64 magnitude = bits & ~kDoubleSign;
  const int negative = (bits & kDoubleSign) != 0 ? 1 : 0;
  if (magnitude > kInfinity) return 0x40;
  if (magnitude == kInfinity) return 0x20 >> negative;
  if (magnitude == 0) return 0x08 >> negative;
  return magnitude < 0x10000000000000 ? 0x02 >> negative : 0;
}

TEST(DoubleInstructions, TestForSpecialValues) {
  ReferenceCheck().check("dftsv", [](const Operands& o) {
    return lanewise<8>([&](u64 a) { return all_ones((kind_of(a) & o.immediate) != 0); })(o.a);
  });
}

TEST(DoubleInstructions, KeepOnlyTheBitsThatTheFpscrHas) {
  TestMachine spu;
  spu.set(4, {0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff});
  spu.program({encode("fscrwr", {0, 4}), encode("fscrrd", {5}), kStop});
  spu.run_to_stop();
  EXPECT_EQ(spu.reg(5), (Words{0xf07, 0x3f07, 0x3f07, 0xf07}));
}

}  // namespace
}  // namespace spu_emu::isa
