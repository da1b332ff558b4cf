#include "isa/encoding/disassembler.h"

#include <string_view>

#include "isa/encoding/instruction_word.h"
#include "isa/encoding/opcodes.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {

unsigned field(std::uint32_t word, unsigned first) {
  return (word >> first) & 0x7fU;
}

/// Where a hint's branch is: 9 signed bits in two pieces, counted in instructions.
std::uint32_t hinted_address(std::uint32_t word, unsigned high_piece, std::uint32_t pc) {
  const auto high = static_cast<std::int32_t>(word << (30U - high_piece)) >> 30;
  const auto distance = high * 128 + static_cast<std::int32_t>(field(word, 0));
  return (pc + static_cast<std::uint32_t>(distance * 4)) & kCodeMask;
}

/// What the feature bits of branches, hints and sync add to the name.
std::string suffix(const Instruction& instruction, std::uint32_t word) {
  const std::string_view name = instruction.mnemonic;
  if (!name.starts_with("bi") && name != "iret" && name != "sync" && name != "hbr") return "";
  const unsigned bits = field(word, 14);
  std::string letters;
  if ((bits & 0x40U) != 0) letters += name == "sync" ? "c" : "p";
  if ((bits & 0x20U) != 0) letters += "d";
  if ((bits & 0x10U) != 0) letters += "e";
  return letters;
}

/// The number goes into the comment.
struct Operand {
  std::string text;
  std::int32_t number = 0;
};

/// A distance of 0 is written as one. The comment has relative addresses as they are before they wrap.
Operand address(const Instruction& instruction, char letter, std::uint32_t word, std::uint32_t pc) {
  const std::int32_t distance = (static_cast<std::int32_t>(word << 9U) >> 16) * 4;
  if (distance == 0) return {"0"};
  return {format("0x%x", static_cast<unsigned>(immediate_of(instruction, word, pc))),
          letter == 'r' ? static_cast<std::int32_t>(pc) + distance : 0};
}

Operand operand(const Instruction& instruction, char letter, std::uint32_t word, std::uint32_t pc) {
  switch (letter) {
    case 't':
      return {format("$%u", field(word, 0))};
    case 'a':
      return {format("$%u", field(word, 7))};
    case 'b':
      return {format("$%u", field(word, 14))};
    case 'c':
      return {format("$%u", field(word, 21))};
    case 's':
      return {format("$sp%u", field(word, 7))};
    case 'h':
      return {format("$ch%u", field(word, 7))};
    case 'k':
      return {format("0x%x", hinted_address(word, 23, pc))};
    case 'K':
      return {format("0x%x", hinted_address(word, 14, pc))};
    case 'r':
    case 'A':
      return address(instruction, letter, word, pc);
    case 'F':
    case 'G':
      return {format("%d", immediate_of(instruction, word, pc))};
    default: {
      const std::int32_t number = immediate_of(instruction, word, pc);
      return {format("%d", number), number};
    }
  }
}

}  // namespace

std::string disassemble(std::uint32_t word, std::uint32_t pc) {
  const int number = find_instruction(word);
  if (number < 0) return format(".long 0x%x", word);
  const Instruction& instruction = instructions()[static_cast<std::size_t>(number)];
  std::string text = instruction.mnemonic + suffix(instruction, word);
  if (*instruction.operands != '\0') text += '\t';
  std::int32_t commented = 0;
  for (const char letter : std::string_view(instruction.operands)) {
    if (letter == ',' || letter == '(' || letter == ')') {
      text += letter;
      continue;
    }
    const Operand shown = operand(instruction, letter, word, pc);
    text += shown.text;
    if (shown.number != 0) commented = shown.number;
  }
  if (commented > 16) text += format("\t# %x", static_cast<unsigned>(commented));
  return text;
}

}  // namespace spu_emu::isa
