// The table of instructions: complete and without overlaps.
#include "isa/encoding/opcodes.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace spu_emu::isa {
namespace {

TEST(Opcodes, AreThoseOfTheAssembler) {
  std::set<std::string> names;
  for (const Instruction& instruction : instructions()) names.insert(instruction.mnemonic);
  EXPECT_EQ(instructions().size(), 199U);
  EXPECT_EQ(names.size(), instructions().size());
}

TEST(Opcodes, EncodeEachInstructionWithoutOverlaps) {
  for (std::size_t i = 0; i < instructions().size(); ++i) {
    const Instruction& instruction = instructions()[i];
    const unsigned bits = opcode_bits(instruction.format);
    const std::uint32_t word = std::uint32_t{instruction.opcode} << 21U;
    EXPECT_EQ(word & (0xffffffffU >> bits), 0U) << instruction.mnemonic;
    EXPECT_EQ(find_instruction(word), static_cast<int>(i)) << instruction.mnemonic;
    EXPECT_EQ(find_instruction(word | (0xffffffffU >> bits)), static_cast<int>(i)) << instruction.mnemonic;
  }
}

}  // namespace
}  // namespace spu_emu::isa
