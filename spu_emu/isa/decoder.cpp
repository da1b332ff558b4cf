#include "isa/decoder.h"

#include <array>
#include <cstring>

#include "isa/handlers.h"
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

std::array<Handler, 256> make_handlers() {
  std::array<Handler, 256> handlers{};
  for (const auto rows :
       {integer_handlers(), logical_handlers(), shift_handlers(), compare_handlers(), shuffle_handlers(),
        memory_handlers(), float_single_handlers(), float_double_handlers(), branch_handlers(),
        channel_handlers(), control_handlers()}) {
    for (const HandlerRow& row : rows)
      handlers.at(static_cast<std::size_t>(find_instruction(row.mnemonic))) = row.handler;
  }
  return handlers;
}

std::uint16_t register_offset(std::uint32_t word, unsigned first) {
  return static_cast<std::uint16_t>(16 * unsigned_field(word, first, 7));
}

Op decode(int number, std::uint32_t word, std::uint32_t pc, std::uint32_t count) {
  static const std::array<Handler, 256> handlers = make_handlers();
  Op op{execute_illegal, 0, 0, 0, 0, 0, pc, count};
  if (number < 0) return op;
  const auto index = static_cast<std::size_t>(number);
  op.run = handlers[index];
  op.t = register_offset(word, 0);
  op.a = register_offset(word, 7);
  op.b = register_offset(word, 14);
  op.c = register_offset(word, 21);
  op.immediate = immediate_of(instructions()[index], word, pc);
  return op;
}

Flow flow_of(int number) {
  return number < 0 ? Flow::leaves : instructions()[static_cast<std::size_t>(number)].flow;
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

std::vector<Op> decode_block(const std::byte* local_store, std::uint32_t pc, std::uint32_t max_instructions,
                             std::uint32_t& words, bool timed) {
  std::vector<Op> ops;
  std::uint32_t count = 0;
  Flow flow = Flow::next;
  while (flow != Flow::leaves && count < max_instructions && pc < kLocalStoreSize) {
    const std::uint32_t word = fetch(local_store, pc);
    const int number = find_instruction(word);
    flow = flow_of(number);
    ++count;
    if (timed) ops.push_back({execute_tick, 0, 0, 0, 0, 0, pc, count});
    if (flow != Flow::none) ops.push_back(decode(number, word, pc, count));
    pc += 4;
  }
  if (flow != Flow::leaves) ops.push_back({execute_end_of_block, 0, 0, 0, 0, 0, pc & kCodeMask, count});
  words = count;
  return ops;
}

}  // namespace spu_emu::isa
