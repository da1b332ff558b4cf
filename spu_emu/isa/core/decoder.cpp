#include "isa/core/decoder.h"

#include <array>

#include "isa/core/handlers.h"
#include "isa/core/instruction_traps.h"
#include "isa/encoding/instruction_word.h"
#include "isa/encoding/opcodes.h"

namespace spu_emu::isa {

namespace {

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
  return static_cast<std::uint16_t>(16 * ((word >> first) & 0x7fU));
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

std::vector<Op> decode_block(const std::byte* local_store, std::uint32_t pc, std::uint32_t max_instructions,
                             std::uint32_t& words, bool observed, const InstructionTraps* traps) {
  std::vector<Op> ops;
  std::uint32_t count = 0;
  Flow flow = Flow::next;
  while (flow != Flow::leaves && count < max_instructions && pc < kLocalStoreSize) {
    const std::uint32_t word = fetch(local_store, pc);
    const int number = find_instruction(word);
    flow = flow_of(number);
    ++count;
    if (traps != nullptr && traps->wants(pc, word)) ops.push_back({execute_trap, 0, 0, 0, 0, 0, pc, count});
    if (observed) ops.push_back({execute_observation, 0, 0, 0, 0, 0, pc, count});
    if (flow != Flow::none) ops.push_back(decode(number, word, pc, count));
    pc += 4;
  }
  if (flow != Flow::leaves) ops.push_back({execute_end_of_block, 0, 0, 0, 0, 0, pc & kCodeMask, count});
  words = count;
  return ops;
}

}  // namespace spu_emu::isa
