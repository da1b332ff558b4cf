#include "isa/debug/instruction_effects.h"

#include <string_view>

#include "isa/encoding/big_endian.h"
#include "isa/encoding/instruction_word.h"
#include "isa/encoding/opcodes.h"

namespace spu_emu::isa {

namespace {

/// The name of the instruction, or nothing.
std::string_view mnemonic(std::uint32_t word) {
  const int number = find_instruction(word);
  return number < 0 ? std::string_view{} : instructions()[static_cast<std::size_t>(number)].mnemonic;
}

std::uint32_t field(std::uint32_t word, unsigned first) {
  return (word >> first) & 0x7fU;
}

}  // namespace

bool is_store_instruction(std::uint32_t word) {
  return mnemonic(word).starts_with("stq");
}

bool is_call_instruction(std::uint32_t word) {
  const std::string_view name = mnemonic(word);
  return (name == "brsl" || name == "brasl" || name == "bisl") && field(word, 0) == 0;
}

std::optional<StoreEffect> store_effect(std::uint32_t word, std::uint32_t pc, const Machine& machine) {
  if (!is_store_instruction(word)) return std::nullopt;
  const Instruction& instruction = instructions()[static_cast<std::size_t>(find_instruction(word))];
  const std::string_view name = instruction.mnemonic;
  auto address = static_cast<std::uint32_t>(immediate_of(instruction, word, pc));
  if (name == "stqd") address += machine.word(field(word, 7), 0);
  if (name == "stqx") address = machine.word(field(word, 7), 0) + machine.word(field(word, 14), 0);
  StoreEffect effect;
  effect.address = address & (kLocalStoreSize - 16);
  for (unsigned slot = 0; slot < 4; ++slot)
    write_word(effect.bytes.data() + 4 * slot, machine.word(field(word, 0), slot));
  return effect;
}

std::optional<ChannelEffect> channel_effect(std::uint32_t word) {
  const std::string_view name = mnemonic(word);
  if (name != "rdch" && name != "wrch") return std::nullopt;
  return ChannelEffect{field(word, 7), name == "wrch", 0};
}

std::optional<ChannelEffect> channel_effect(std::uint32_t word, const Machine& machine) {
  auto effect = channel_effect(word);
  if (effect && effect->write) effect->value = machine.word(field(word, 0), 0);
  return effect;
}

}  // namespace spu_emu::isa
