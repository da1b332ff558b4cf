// Cycles as a host program reads them: by function, at well-defined moments, the same in every run.
#include <thread>

#include "../isa_context.h"
#include "isa/timing/code_ranges.h"

namespace spu_emu::isa {
namespace {

EmulationSettings timed() {
  EmulationSettings settings;
  settings.cycles.emplace();
  return settings;
}

/// Two functions: `begin` at 0x80 calls the other one three times.
File two_functions() {
  const Code caller = {encode("il", {5, 3}), encode("brsl", {0, 0x100 - 0x84}), encode("ai", {5, 5, -1}),
                       encode("brnz", {5, -8}), stop_with(0x2000)};
  const Code callee = {encode("ai", {6, 6, 1}), encode("ai", {6, 6, 1}), encode("bi", {0})};
  return ElfBuilder(0x80, {{0x80, caller}, {0x100, callee}}, {{"begin", 0x80}, {"_ZN4step3runEv", 0x100}})
      .build();
}

TEST(CycleProfile, CountsEachFunctionsOwnCycles) {
  IsaContext context(two_functions(), timed());
  ASSERT_EQ(context.run(), 0) << last_fault(context.spe);
  const CycleProfile profile = cycle_profile(context.spe);
  ASSERT_EQ(profile.functions.size(), 2U);
  EXPECT_EQ(profile.functions[0].name, "begin");
  EXPECT_EQ(profile.functions[1].name, "step::run()") << "names are demangled";
  EXPECT_EQ(profile.functions[0].counts.instructions, 1U + 3 * 3 + 1);
  EXPECT_EQ(profile.functions[1].counts.instructions, 3U * 3);
  EXPECT_EQ(profile.total.instructions, statistics(context.spe).instructions);
  EXPECT_EQ(profile.total.cycles, profile.functions[0].counts.cycles + profile.functions[1].counts.cycles);
  EXPECT_GT(profile.functions[1].counts.stall(Stall::branch_miss), 0U) << "the call was not hinted";
}

TEST(CycleProfile, IsEmptyUnlessAskedFor) {
  IsaContext context(two_functions());
  ASSERT_EQ(context.run(), 0);
  EXPECT_EQ(cycle_profile(context.spe).total.cycles, 0U);
  EXPECT_TRUE(cycle_profile(context.spe).functions.empty());
}

TEST(CycleProfile, AddsUpOverTheRunsOfALoadedProgram) {
  IsaContext context(two_functions(), timed());
  ASSERT_EQ(context.run(), 0);
  const CycleProfile once = cycle_profile(context.spe);
  ASSERT_EQ(context.run(), 0);
  CycleCounts second = cycle_profile(context.spe).total;
  second -= once.total;
  EXPECT_EQ(second.cycles, once.total.cycles);
  EXPECT_EQ(second.stalls, once.total.stalls);
}

TEST(CycleProfile, IsTheSameForEveryDmaModeAndRun) {
  alignas(128) static std::array<std::uint32_t, 32> words{};
  Code code;
  append_wait(append_dma(code, 0x40, 0x1000, 128));
  append_wait(append_dma(code, 0x20, 0x1000, 128));
  code.push_back(stop_with(0x2000));
  std::vector<std::uint64_t> cycles;
  for (const DmaMode mode : {DmaMode::eager, DmaMode::late, DmaMode::unchecked, DmaMode::eager}) {
    EmulationSettings settings = timed();
    settings.dma_mode = mode;
    IsaContext context(code, settings);
    ASSERT_EQ(context.run(words.data()), 0) << last_fault(context.spe);
    cycles.push_back(cycle_profile(context.spe).total.cycles);
  }
  EXPECT_GT(cycles.front(), 2 * 750U) << "two latencies of main memory";
  for (const std::uint64_t each : cycles) EXPECT_EQ(each, cycles.front());
}

TEST(CycleProfile, EndsAtTheMessageThatTellsTheHost) {
  // Four instructions before the message; whatever the SPU does until the host looks is not counted yet.
  const Code code = {encode("il", {3, 7}),    encode("nop", {0}), encode("nop", {0}),      encode("nop", {0}),
                     encode("wrch", {28, 3}), encode("nop", {0}), encode("rdch", {4, 29}), stop_with(0x2000)};
  for (int turn = 0; turn < 20; ++turn) {
    IsaContext context(code, timed());
    std::thread spe([&] { EXPECT_EQ(context.run(), 0); });
    unsigned int word = 0;
    while (spe_out_mbox_read(context.spe, &word, 1) != 1) std::this_thread::yield();
    EXPECT_EQ(cycle_profile(context.spe).total.instructions, 4U);
    spe_in_mbox_write(context.spe, &word, 1, SPE_MBOX_ANY_NONBLOCKING);
    spe.join();
    EXPECT_EQ(cycle_profile(context.spe).total.instructions, 8U);
    EXPECT_EQ(cycle_profile(context.spe).total.cycles, 8U) << "a mailbox takes no time";
  }
}

TEST(CycleProfile, AnInstructionThatBreaksARuleIsNotCounted) {
  const Code code = {encode("nop", {0}), encode("rdch", {3, 60})};
  IsaContext context(code, timed());
  EXPECT_NE(context.run(), 0);
  EXPECT_EQ(cycle_profile(context.spe).total.instructions, 1U);
}

TEST(CodeRanges, OfSymbolsReachToTheirSizeOrToTheNextOne) {
  const std::vector<ElfSymbol> symbols = {{0x80, 0x20, "sized"}, {0x80, 0x20, "alias"}, {0x90, 0, "label"},
                                          {0xc0, 0, "open"},     {0x100, 0, "last"},    {0x200, 0, "_end"}};
  const std::vector<CodeRange> ranges = code_ranges(symbols, 0x200);
  ASSERT_EQ(ranges.size(), 4U);
  EXPECT_EQ(ranges[0].name, "sized");
  EXPECT_EQ(ranges[0].end, 0xa0U);
  EXPECT_EQ(ranges[1].name, "open");
  EXPECT_EQ(ranges[1].end, 0x100U);
  EXPECT_EQ(ranges[2].end, 0x200U);
  EXPECT_EQ(ranges[3].first, ranges[3].end) << "nothing lies behind the image";
}

TEST(CodeRanges, OfBrokenSizesDoNotOverlap) {
  const std::vector<ElfSymbol> symbols = {{0x80, 0xffffffff, "huge"}, {0x100, 0xffffffff, "huge too"}};
  const std::vector<CodeRange> ranges = code_ranges(symbols, 0x200);
  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_EQ(ranges[0].end, 0x100U);
}

}  // namespace
}  // namespace spu_emu::isa
