#include "isa/encoding/opcodes.h"

#include <algorithm>
#include <array>

namespace spu_emu::isa {

namespace {

using enum Unit;
using enum Flow;

constexpr Instruction kInstructions[] = {
    // Loads and stores.
    {"lqd", Format::ri10, 0x1a0, "t,d(a)", ls},
    {"stqd", Format::ri10, 0x120, "t,d(a)", ls},
    {"lqx", Format::rr, 0x1c4, "t,a,b", ls},
    {"stqx", Format::rr, 0x144, "t,a,b", ls},
    {"lqa", Format::ri16, 0x184, "t,A", ls},
    {"stqa", Format::ri16, 0x104, "t,A", ls},
    {"lqr", Format::ri16, 0x19c, "t,r", ls},
    {"stqr", Format::ri16, 0x11c, "t,r", ls},
    // Masks for insertion.
    {"cbd", Format::ri7, 0x1f4, "t,7(a)", shuf},
    {"chd", Format::ri7, 0x1f5, "t,7(a)", shuf},
    {"cwd", Format::ri7, 0x1f6, "t,7(a)", shuf},
    {"cdd", Format::ri7, 0x1f7, "t,7(a)", shuf},
    {"cbx", Format::rr, 0x1d4, "t,a,b", shuf},
    {"chx", Format::rr, 0x1d5, "t,a,b", shuf},
    {"cwx", Format::rr, 0x1d6, "t,a,b", shuf},
    {"cdx", Format::rr, 0x1d7, "t,a,b", shuf},
    // Constants.
    {"ilh", Format::ri16, 0x20c, "t,u", fx2},
    {"ilhu", Format::ri16, 0x208, "t,u", fx2},
    {"il", Format::ri16, 0x204, "t,I", fx2},
    {"ila", Format::ri18, 0x210, "t,U", fx2},
    {"iohl", Format::ri16, 0x304, "t,u", fx2},
    {"fsmbi", Format::ri16, 0x194, "t,u", shuf},
    // Integer arithmetic.
    {"ah", Format::rr, 0x0c8, "t,a,b", fx2},
    {"a", Format::rr, 0x0c0, "t,a,b", fx2},
    {"sfh", Format::rr, 0x048, "t,a,b", fx2},
    {"sf", Format::rr, 0x040, "t,a,b", fx2},
    {"ahi", Format::ri10, 0x0e8, "t,a,i", fx2},
    {"ai", Format::ri10, 0x0e0, "t,a,i", fx2},
    {"sfhi", Format::ri10, 0x068, "t,a,i", fx2},
    {"sfi", Format::ri10, 0x060, "t,a,i", fx2},
    {"addx", Format::rr, 0x340, "t,a,b", fx2},
    {"cg", Format::rr, 0x0c2, "t,a,b", fx2},
    {"cgx", Format::rr, 0x342, "t,a,b", fx2},
    {"sfx", Format::rr, 0x341, "t,a,b", fx2},
    {"bg", Format::rr, 0x042, "t,a,b", fx2},
    {"bgx", Format::rr, 0x343, "t,a,b", fx2},
    {"mpy", Format::rr, 0x3c4, "t,a,b", fp7},
    {"mpyu", Format::rr, 0x3cc, "t,a,b", fp7},
    {"mpyh", Format::rr, 0x3c5, "t,a,b", fp7},
    {"mpys", Format::rr, 0x3c7, "t,a,b", fp7},
    {"mpyhh", Format::rr, 0x3c6, "t,a,b", fp7},
    {"mpyhha", Format::rr, 0x346, "t,a,b", fp7},
    {"mpyhhu", Format::rr, 0x3ce, "t,a,b", fp7},
    {"mpyhhau", Format::rr, 0x34e, "t,a,b", fp7},
    {"mpyi", Format::ri10, 0x3a0, "t,a,i", fp7},
    {"mpyui", Format::ri10, 0x3a8, "t,a,i", fp7},
    {"mpya", Format::rrr, 0x600, "c,a,b,t", fp7},
    {"clz", Format::rr, 0x2a5, "t,a", fx2},
    {"xsbh", Format::rr, 0x2b6, "t,a", fx2},
    {"xshw", Format::rr, 0x2ae, "t,a", fx2},
    {"xswd", Format::rr, 0x2a6, "t,a", fx2},
    {"cntb", Format::rr, 0x2b4, "t,a", fxb},
    {"avgb", Format::rr, 0x0d3, "t,a,b", fxb},
    {"absdb", Format::rr, 0x053, "t,a,b", fxb},
    {"sumb", Format::rr, 0x253, "t,a,b", fxb},
    {"fsmb", Format::rr, 0x1b6, "t,a", shuf},
    {"fsmh", Format::rr, 0x1b5, "t,a", shuf},
    {"fsm", Format::rr, 0x1b4, "t,a", shuf},
    {"gbb", Format::rr, 0x1b2, "t,a", shuf},
    {"gbh", Format::rr, 0x1b1, "t,a", shuf},
    {"gb", Format::rr, 0x1b0, "t,a", shuf},
    // Logic.
    {"and", Format::rr, 0x0c1, "t,a,b", fx2},
    {"andc", Format::rr, 0x2c1, "t,a,b", fx2},
    {"or", Format::rr, 0x041, "t,a,b", fx2},
    {"orc", Format::rr, 0x2c9, "t,a,b", fx2},
    {"xor", Format::rr, 0x241, "t,a,b", fx2},
    {"nand", Format::rr, 0x0c9, "t,a,b", fx2},
    {"nor", Format::rr, 0x049, "t,a,b", fx2},
    {"eqv", Format::rr, 0x249, "t,a,b", fx2},
    {"andbi", Format::ri10, 0x0b0, "t,a,i", fx2},
    {"andhi", Format::ri10, 0x0a8, "t,a,i", fx2},
    {"andi", Format::ri10, 0x0a0, "t,a,i", fx2},
    {"orbi", Format::ri10, 0x030, "t,a,i", fx2},
    {"orhi", Format::ri10, 0x028, "t,a,i", fx2},
    {"ori", Format::ri10, 0x020, "t,a,i", fx2},
    {"xorbi", Format::ri10, 0x230, "t,a,i", fx2},
    {"xorhi", Format::ri10, 0x228, "t,a,i", fx2},
    {"xori", Format::ri10, 0x220, "t,a,i", fx2},
    {"orx", Format::rr, 0x1f0, "t,a", shuf},
    {"selb", Format::rrr, 0x400, "c,a,b,t", fx2},
    {"shufb", Format::rrr, 0x580, "c,a,b,t", shuf},
    // Shifts and rotates.
    {"shlh", Format::rr, 0x05f, "t,a,b", fx3},
    {"shl", Format::rr, 0x05b, "t,a,b", fx3},
    {"roth", Format::rr, 0x05c, "t,a,b", fx3},
    {"rot", Format::rr, 0x058, "t,a,b", fx3},
    {"rothm", Format::rr, 0x05d, "t,a,b", fx3},
    {"rotm", Format::rr, 0x059, "t,a,b", fx3},
    {"rotmah", Format::rr, 0x05e, "t,a,b", fx3},
    {"rotma", Format::rr, 0x05a, "t,a,b", fx3},
    {"shlhi", Format::ri7, 0x07f, "t,a,7", fx3},
    {"shli", Format::ri7, 0x07b, "t,a,7", fx3},
    {"rothi", Format::ri7, 0x07c, "t,a,7", fx3},
    {"roti", Format::ri7, 0x078, "t,a,7", fx3},
    {"rothmi", Format::ri7, 0x07d, "t,a,7", fx3},
    {"rotmi", Format::ri7, 0x079, "t,a,7", fx3},
    {"rotmahi", Format::ri7, 0x07e, "t,a,7", fx3},
    {"rotmai", Format::ri7, 0x07a, "t,a,7", fx3},
    {"shlqbi", Format::rr, 0x1db, "t,a,b", shuf},
    {"shlqby", Format::rr, 0x1df, "t,a,b", shuf},
    {"shlqbybi", Format::rr, 0x1cf, "t,a,b", shuf},
    {"rotqbi", Format::rr, 0x1d8, "t,a,b", shuf},
    {"rotqby", Format::rr, 0x1dc, "t,a,b", shuf},
    {"rotqbybi", Format::rr, 0x1cc, "t,a,b", shuf},
    {"rotqmbi", Format::rr, 0x1d9, "t,a,b", shuf},
    {"rotqmby", Format::rr, 0x1dd, "t,a,b", shuf},
    {"rotqmbybi", Format::rr, 0x1cd, "t,a,b", shuf},
    {"shlqbii", Format::ri7, 0x1fb, "t,a,7", shuf},
    {"shlqbyi", Format::ri7, 0x1ff, "t,a,7", shuf},
    {"rotqbii", Format::ri7, 0x1f8, "t,a,7", shuf},
    {"rotqbyi", Format::ri7, 0x1fc, "t,a,7", shuf},
    {"rotqmbii", Format::ri7, 0x1f9, "t,a,7", shuf},
    {"rotqmbyi", Format::ri7, 0x1fd, "t,a,7", shuf},
    // Compares.
    {"ceqb", Format::rr, 0x3d0, "t,a,b", fx2},
    {"ceqh", Format::rr, 0x3c8, "t,a,b", fx2},
    {"ceq", Format::rr, 0x3c0, "t,a,b", fx2},
    {"cgtb", Format::rr, 0x250, "t,a,b", fx2},
    {"cgth", Format::rr, 0x248, "t,a,b", fx2},
    {"cgt", Format::rr, 0x240, "t,a,b", fx2},
    {"clgtb", Format::rr, 0x2d0, "t,a,b", fx2},
    {"clgth", Format::rr, 0x2c8, "t,a,b", fx2},
    {"clgt", Format::rr, 0x2c0, "t,a,b", fx2},
    {"ceqbi", Format::ri10, 0x3f0, "t,a,i", fx2},
    {"ceqhi", Format::ri10, 0x3e8, "t,a,i", fx2},
    {"ceqi", Format::ri10, 0x3e0, "t,a,i", fx2},
    {"cgtbi", Format::ri10, 0x270, "t,a,i", fx2},
    {"cgthi", Format::ri10, 0x268, "t,a,i", fx2},
    {"cgti", Format::ri10, 0x260, "t,a,i", fx2},
    {"clgtbi", Format::ri10, 0x2f0, "t,a,i", fx2},
    {"clgthi", Format::ri10, 0x2e8, "t,a,i", fx2},
    {"clgti", Format::ri10, 0x2e0, "t,a,i", fx2},
    // Floating point.
    {"fa", Format::rr, 0x2c4, "t,a,b", fp6},
    {"fs", Format::rr, 0x2c5, "t,a,b", fp6},
    {"fm", Format::rr, 0x2c6, "t,a,b", fp6},
    {"fma", Format::rrr, 0x700, "c,a,b,t", fp6},
    {"fms", Format::rrr, 0x780, "c,a,b,t", fp6},
    {"fnms", Format::rrr, 0x680, "c,a,b,t", fp6},
    {"fceq", Format::rr, 0x3c2, "t,a,b", fx2},
    {"fcmeq", Format::rr, 0x3ca, "t,a,b", fx2},
    {"fcgt", Format::rr, 0x2c2, "t,a,b", fx2},
    {"fcmgt", Format::rr, 0x2ca, "t,a,b", fx2},
    {"frest", Format::rr, 0x1b8, "t,a", shuf},
    {"frsqest", Format::rr, 0x1b9, "t,a", shuf},
    {"fi", Format::rr, 0x3d4, "t,a,b", fp7},
    {"cflts", Format::ri8, 0x3b0, "t,a,F", fp7},
    {"cfltu", Format::ri8, 0x3b2, "t,a,F", fp7},
    {"csflt", Format::ri8, 0x3b4, "t,a,G", fp7},
    {"cuflt", Format::ri8, 0x3b6, "t,a,G", fp7},
    {"dfa", Format::rr, 0x2cc, "t,a,b", fpd},
    {"dfs", Format::rr, 0x2cd, "t,a,b", fpd},
    {"dfm", Format::rr, 0x2ce, "t,a,b", fpd},
    {"dfma", Format::rr, 0x35c, "t,a,b", fpd},
    {"dfms", Format::rr, 0x35d, "t,a,b", fpd},
    {"dfnms", Format::rr, 0x35e, "t,a,b", fpd},
    {"dfnma", Format::rr, 0x35f, "t,a,b", fpd},
    {"dfceq", Format::rr, 0x3c3, "t,a,b", fx2},
    {"dfcmeq", Format::rr, 0x3cb, "t,a,b", fx2},
    {"dfcgt", Format::rr, 0x2c3, "t,a,b", fx2},
    {"dfcmgt", Format::rr, 0x2cb, "t,a,b", fx2},
    {"dftsv", Format::ri7, 0x3bf, "t,a,7", fx2},
    {"fesd", Format::rr, 0x3b8, "t,a", fpd},
    {"frds", Format::rr, 0x3b9, "t,a", fpd},
    {"fscrrd", Format::rr, 0x398, "t", fpd},
    {"fscrwr", Format::rr, 0x3ba, "t,a", fp7},
    // Branches.
    {"br", Format::ri16, 0x190, "r", br, leaves},
    {"bra", Format::ri16, 0x180, "A", br, leaves},
    {"brsl", Format::ri16, 0x198, "t,r", br, leaves},
    {"brasl", Format::ri16, 0x188, "t,A", br, leaves},
    {"brz", Format::ri16, 0x100, "t,r", br, may_leave},
    {"brnz", Format::ri16, 0x108, "t,r", br, may_leave},
    {"brhz", Format::ri16, 0x110, "t,r", br, may_leave},
    {"brhnz", Format::ri16, 0x118, "t,r", br, may_leave},
    {"bi", Format::rr, 0x1a8, "a", br, leaves},
    {"bisl", Format::rr, 0x1a9, "t,a", br, leaves},
    {"iret", Format::rr, 0x1aa, "a", br, leaves},
    {"bisled", Format::rr, 0x1ab, "t,a", br, leaves},
    {"biz", Format::rr, 0x128, "t,a", br, may_leave},
    {"binz", Format::rr, 0x129, "t,a", br, may_leave},
    {"bihz", Format::rr, 0x12a, "t,a", br, may_leave},
    {"bihnz", Format::rr, 0x12b, "t,a", br, may_leave},
    {"hbr", Format::rr, 0x1ac, "K,a", ls, none},
    {"hbra", Format::ri18, 0x080, "k,A", ls, none},
    {"hbrr", Format::ri18, 0x090, "k,r", ls, none},
    // Control.
    {"heq", Format::rr, 0x3d8, "t,a,b", fx2, may_leave},
    {"hgt", Format::rr, 0x258, "t,a,b", fx2, may_leave},
    {"hlgt", Format::rr, 0x2d8, "t,a,b", fx2, may_leave},
    {"heqi", Format::ri10, 0x3f8, "t,a,i", fx2, may_leave},
    {"hgti", Format::ri10, 0x278, "t,a,i", fx2, may_leave},
    {"hlgti", Format::ri10, 0x2f8, "t,a,i", fx2, may_leave},
    {"stop", Format::rr, 0x000, "", br, leaves},
    {"stopd", Format::rr, 0x140, "t,a,b", br, leaves},
    {"lnop", Format::rr, 0x001, "", lnop, none},
    {"nop", Format::rr, 0x201, "t", nop, none},
    {"sync", Format::rr, 0x002, "", br, none},
    {"dsync", Format::rr, 0x003, "", br, none},
    {"mfspr", Format::rr, 0x00c, "t,s", spr},
    {"mtspr", Format::rr, 0x10c, "s,t", spr, none},
    {"rdch", Format::rr, 0x00d, "t,h", spr, leaves},
    {"rchcnt", Format::rr, 0x00f, "t,h", spr, leaves},
    {"wrch", Format::rr, 0x10d, "h,t", spr, leaves},
};

constexpr std::size_t kCodes = 1U << 11U;

/// The number of the instruction for each value of the leading 11 bits.
constexpr std::array<std::int16_t, kCodes> make_numbers() {
  std::array<std::int16_t, kCodes> numbers{};
  numbers.fill(-1);
  for (std::size_t i = 0; i < std::size(kInstructions); ++i) {
    const Instruction& instruction = kInstructions[i];
    const unsigned codes = 1U << (11U - opcode_bits(instruction.format));
    for (unsigned k = 0; k < codes; ++k) numbers[instruction.opcode + k] = static_cast<std::int16_t>(i);
  }
  return numbers;
}

constexpr std::array<std::int16_t, kCodes> kNumbers = make_numbers();

}  // namespace

std::span<const Instruction> instructions() {
  return kInstructions;
}

int find_instruction(std::uint32_t word) {
  return kNumbers[word >> 21U];
}

int find_instruction(std::string_view mnemonic) {
  const auto* found =
      std::ranges::find_if(kInstructions, [&](const Instruction& i) { return mnemonic == i.mnemonic; });
  return found == std::end(kInstructions) ? -1 : static_cast<int>(found - std::begin(kInstructions));
}

}  // namespace spu_emu::isa
