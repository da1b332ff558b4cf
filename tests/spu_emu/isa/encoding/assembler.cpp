#include "assembler.h"

#include <stdexcept>
#include <string>

#include "isa/encoding/opcodes.h"

namespace spu_emu::isa {

namespace {

std::uint32_t masked(std::int32_t value, unsigned bits, unsigned first) {
  return (static_cast<std::uint32_t>(value) & ((1U << bits) - 1)) << first;
}

/// The distance of a hint to its branch: 9 bits of words, the upper two in a place of their own.
std::uint32_t hint_distance(std::int32_t value, unsigned upper) {
  return masked(value / 4, 7, 0) | masked(value / 4 >> 7, 2, upper);
}

std::uint32_t operand_bits(char letter, std::int32_t value) {
  switch (letter) {
    case 't':
      return masked(value, 7, 0);
    case 'a':
    case 's':
    case 'h':
      return masked(value, 7, 7);
    case 'b':
    case '7':
      return masked(value, 7, 14);
    case 'c':
      return masked(value, 7, 21);
    case 'i':
      return masked(value, 10, 14);
    case 'd':
      return masked(value / 16, 10, 14);
    case 'I':
    case 'u':
      return masked(value, 16, 7);
    case 'U':
      return masked(value, 18, 7);
    case 'F':
      return masked(173 - value, 8, 14);
    case 'G':
      return masked(155 - value, 8, 14);
    case 'r':
    case 'A':
      return masked(value / 4, 16, 7);
    case 'k':
      return hint_distance(value, 23);
    case 'K':
      return hint_distance(value, 14);
    default:
      return 0;
  }
}

}  // namespace

std::uint32_t encode(std::string_view mnemonic, std::initializer_list<std::int32_t> operands) {
  return encode(mnemonic, std::span(operands.begin(), operands.size()));
}

std::uint32_t encode(std::string_view mnemonic, std::span<const std::int32_t> operands) {
  const int number = find_instruction(mnemonic);
  if (number < 0) throw std::invalid_argument("no instruction " + std::string(mnemonic));
  const Instruction& instruction = instructions()[static_cast<std::size_t>(number)];
  std::uint32_t word = std::uint32_t{instruction.opcode} << 21U;
  auto next = operands.begin();
  for (const char letter : std::string_view(instruction.operands)) {
    if (letter == ',' || letter == '(' || letter == ')') continue;
    if (next == operands.end()) throw std::invalid_argument("too few operands: " + std::string(mnemonic));
    word |= operand_bits(letter, *next++);
  }
  if (next != operands.end()) throw std::invalid_argument("too many operands: " + std::string(mnemonic));
  return word;
}

}  // namespace spu_emu::isa
