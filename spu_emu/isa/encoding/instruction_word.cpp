#include "isa/encoding/instruction_word.h"

#include <cstring>
#include <string_view>

#include "mfc/byte_order.h"

namespace spu_emu::isa {

namespace {

std::int32_t signed_field(std::uint32_t word, unsigned first, unsigned size) {
  return static_cast<std::int32_t>(word << (32 - first - size)) >> (32 - size);
}

std::int32_t unsigned_field(std::uint32_t word, unsigned first, unsigned size) {
  return static_cast<std::int32_t>((word >> first) & ((1U << size) - 1));
}

std::int32_t code_address(std::uint32_t address) {
  return static_cast<std::int32_t>(address & kCodeMask);
}

/// What the letter of an operand says, 0 for registers.
std::int32_t operand_value(char letter, std::uint32_t word, std::uint32_t pc) {
  switch (letter) {
    case '7':
      return signed_field(word, 14, 7);
    case 'i':
      return signed_field(word, 14, 10);
    case 'd':
      return signed_field(word, 14, 10) * 16;
    case 'I':
      return signed_field(word, 7, 16);
    case 'u':
      return unsigned_field(word, 7, 16);
    case 'U':
      return unsigned_field(word, 7, 18);
    case 'p':
      return unsigned_field(word, 0, 14);
    case 'F':
      return 173 - unsigned_field(word, 14, 8);
    case 'G':
      return 155 - unsigned_field(word, 14, 8);
    case 'r':
      return code_address(pc + static_cast<std::uint32_t>(signed_field(word, 7, 16) * 4));
    case 'A':
      return code_address(static_cast<std::uint32_t>(signed_field(word, 7, 16) * 4));
    case 'h':
      return unsigned_field(word, 7, 7);
    default:
      return 0;
  }
}

/// Branches to a register's address keep what they do with interrupts in two bits.
bool has_interrupt_bits(const Instruction& instruction) {
  const std::string_view mnemonic = instruction.mnemonic;
  return mnemonic.starts_with("bi") || mnemonic == "iret";
}

}  // namespace

std::int32_t immediate_of(const Instruction& instruction, std::uint32_t word, std::uint32_t pc) {
  if (has_interrupt_bits(instruction)) return unsigned_field(word, 18, 2);
  if (std::strcmp(instruction.mnemonic, "stop") == 0) return operand_value('p', word, pc);
  std::int32_t value = 0;
  for (const char* letter = instruction.operands; *letter != '\0'; ++letter)
    value |= operand_value(*letter, word, pc);
  return value;
}

// Bytes of a transfer in flight are forbidden to AddressSanitizer, but not to the SPU.
__attribute__((no_sanitize("address"))) std::uint32_t fetch(const std::byte* local_store, std::uint32_t pc) {
  return big_endian(*reinterpret_cast<const std::uint32_t*>(local_store + pc));
}

}  // namespace spu_emu::isa
