/// @file
/// The instructions of the SPU: names, encodings, operands, and the unit that executes each of them.
#ifndef SPU_EMU_ISA_ENCODING_OPCODES_H
#define SPU_EMU_ISA_ENCODING_OPCODES_H

#include <cstdint>
#include <span>
#include <string_view>

namespace spu_emu::isa {

/// How many of the leading bits are the opcode, and what follows them: a fourth register, an immediate of
/// 7, 8, 10, 16 or 18 bits, or none.
enum class Format : std::uint8_t { rr, rrr, ri7, ri8, ri10, ri16, ri18 };

/// Bits of a format's opcode, from the most significant bit of the instruction on.
constexpr unsigned opcode_bits(Format format) {
  constexpr unsigned kBits[] = {11, 4, 11, 10, 8, 9, 7};
  return kBits[static_cast<unsigned>(format)];
}

/// Execution units: fixed point (simple, shift, byte), floating point (single, integer, double), no operation
/// of the even pipe; shuffle, load and store, branch, channel, no operation of the odd pipe.
enum class Unit : std::uint8_t { fx2, fx3, fxb, fp6, fp7, fpd, nop, shuf, ls, br, spr, lnop };

constexpr bool is_even_pipe(Unit unit) {
  return unit <= Unit::nop;
}

/// What comes after an instruction: the next one; the next one or another place; always another place, or at
/// least a look at the world outside; `none` is the next one after no effect at all.
enum class Flow : std::uint8_t { next, may_leave, leaves, none };

/// One instruction. `operands` is how the assembler writes them: registers t, a, b, c by the field they come
/// from, s and h special register and channel in field a; immediates 7, 10 (as i; d scaled by 16), 16 (signed
/// I, unsigned u), 18 (U) bits, p the 14 bits of stop, F and G the scales of conversions; r and A relative
/// and absolute addresses, k and K the two places where hints keep a branch's address.
struct Instruction {
  const char* mnemonic;
  Format format;
  std::uint16_t opcode;  // as the 11 leading bits
  const char* operands;
  Unit unit;
  Flow flow = Flow::next;
};

/// All of them; an instruction's place in here is its number everywhere else.
std::span<const Instruction> instructions();

/// The number of the instruction that a word encodes, or -1.
int find_instruction(std::uint32_t word);

/// The number of the instruction with this name, or -1.
int find_instruction(std::string_view mnemonic);

}  // namespace spu_emu::isa

#endif
