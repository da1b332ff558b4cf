// Instructions as text: by hand, and against what objdump wrote of words of every instruction.
#include "isa/encoding/disassembler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "assembler.h"

namespace spu_emu::isa {
namespace {

TEST(Disassembler, WritesWhatTheAssemblerReads) {
  EXPECT_EQ(disassemble(encode("lnop", {}), 0), "lnop");
  EXPECT_EQ(disassemble(encode("nop", {127}), 0), "nop\t$127");
  EXPECT_EQ(disassemble(encode("ai", {3, 4, -5}), 0), "ai\t$3,$4,-5");
  EXPECT_EQ(disassemble(encode("ai", {3, 4, 100}), 0), "ai\t$3,$4,100\t# 64");
  EXPECT_EQ(disassemble(encode("lqd", {3, 64, 1}), 0), "lqd\t$3,64($1)\t# 40");
  EXPECT_EQ(disassemble(encode("cwd", {3, 8, 1}), 0), "cwd\t$3,8($1)");
  EXPECT_EQ(disassemble(encode("shufb", {1, 2, 3, 4}), 0), "shufb\t$1,$2,$3,$4");
  EXPECT_EQ(disassemble(encode("br", {-16}), 0x100), "br\t0xf0\t# f0");
  EXPECT_EQ(disassemble(encode("brsl", {0, 0x100}), 0x80), "brsl\t$0,0x180\t# 180");
  EXPECT_EQ(disassemble(encode("lqa", {3, 0x400}), 0), "lqa\t$3,0x400");
  EXPECT_EQ(disassemble(encode("cflts", {3, 4, 10}), 0), "cflts\t$3,$4,10");
  EXPECT_EQ(disassemble(encode("rdch", {3, 29}), 0), "rdch\t$3,$ch29");
  EXPECT_EQ(disassemble(encode("wrch", {21, 3}), 0), "wrch\t$ch21,$3");
  EXPECT_EQ(disassemble(encode("bi", {6}) | kInterruptsOn, 0), "bie\t$6");
  EXPECT_EQ(disassemble(encode("iret", {0}) | kInterruptsOff, 0), "iretd\t$0");
  EXPECT_EQ(disassemble(0x00800000, 0), ".long 0x800000");
}

TEST(Disassembler, AgreesWithObjdumpOnEveryInstruction) {
  std::ifstream file(SPU_EMU_DISASSEMBLY);
  ASSERT_TRUE(file) << SPU_EMU_DISASSEMBLY;
  int lines = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream in(line);
    std::uint32_t pc = 0;
    std::uint32_t word = 0;
    in >> std::hex >> pc >> word;
    std::string expected;
    std::getline(in >> std::ws, expected);
    std::string text = disassemble(word, pc);
    std::ranges::replace(text, '\t', ' ');
    EXPECT_EQ(text, expected) << line;
    ++lines;
  }
  EXPECT_EQ(lines, 3 * 199 + 8);
}

}  // namespace
}  // namespace spu_emu::isa
