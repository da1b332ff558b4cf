// Issue, dual issue and operands: programs whose cycles are counted by hand. "@3" is the cycle, from 0, in
// which an instruction issues; a program takes one more than the cycle of its last one.
#include <vector>

#include "timed_machine.h"

namespace spu_emu::isa {
namespace {

std::uint32_t add_one(std::int32_t target, std::int32_t source) {
  return encode("ai", {target, source, 1});
}

std::uint32_t load(std::int32_t target) {
  return encode("lqd", {target, 0, 100});
}

TEST(Pipeline, AnAddIsReadyForTheNextAfterTwoCycles) {
  // @0, @2, @4, @6; the stop, first of its pair of words, @7
  const CycleCounts counts =
      count_cycles({add_one(3, 3), add_one(3, 3), add_one(3, 3), add_one(3, 3), kStop});
  EXPECT_EQ(counts.cycles, 8U);
  EXPECT_EQ(counts.instructions, 5U);
  EXPECT_EQ(counts.stall(Stall::fixed), 3U);
  EXPECT_EQ(counts.dual_issued, 0U);
}

TEST(Pipeline, ALoadIsReadyAfterSixCycles) {
  // @0; the add @6, five cycles later than it might; the stop @7
  const CycleCounts counts = count_cycles({load(3), add_one(4, 3), kStop});
  EXPECT_EQ(counts.cycles, 8U);
  EXPECT_EQ(counts.stall(Stall::load), 5U);
}

TEST(Pipeline, EveryClassHasItsLatency) {
  struct Case {
    std::uint32_t instruction;
    std::uint64_t latency;
    Stall cause;
  };
  const Case cases[] = {{encode("a", {3, 4, 5}), 2, Stall::fixed},
                        {encode("fcgt", {3, 4, 5}), 2, Stall::fixed},
                        {encode("shl", {3, 4, 5}), 4, Stall::fixed},
                        {encode("cntb", {3, 4}), 4, Stall::fixed},
                        {encode("fma", {3, 4, 5, 6}), 6, Stall::floating},
                        {encode("mpy", {3, 4, 5}), 7, Stall::floating},
                        {encode("csflt", {3, 4, 0}), 7, Stall::floating},
                        {encode("rotqby", {3, 4, 5}), 4, Stall::shuffle},
                        {encode("rdch", {3, SPU_RdEventMask}), 6, Stall::channel}};
  for (const Case& c : cases) {
    // The instruction @0, the add when it is ready, the stop one later.
    const CycleCounts counts = count_cycles({c.instruction, add_one(10, 3), kStop});
    EXPECT_EQ(counts.cycles, c.latency + 2) << std::hex << c.instruction;
    EXPECT_EQ(counts.stall(c.cause), c.latency - 1) << std::hex << c.instruction;
  }
}

TEST(Pipeline, InstructionsOfBothPipesIssueInPairs) {
  // Each pair together: @0, @1, @2, @3
  const CycleCounts counts = count_cycles({add_one(3, 3), load(10), add_one(4, 4), load(11),  //
                                           add_one(5, 5), load(12), add_one(6, 6), kStop});
  EXPECT_EQ(counts.cycles, 4U);
  EXPECT_EQ(counts.dual_issued, 4U);
  EXPECT_DOUBLE_EQ(counts.cpi(), 0.5);
  EXPECT_DOUBLE_EQ(counts.dual_issue_share(), 1.0);
}

TEST(Pipeline, AnOddInstructionFirstHasNoPartner) {
  // @0, @1, @2, @3, @4: neither order within a pair of words, nor across two of them
  const CycleCounts counts = count_cycles({load(10), add_one(3, 3), load(11), add_one(4, 4), kStop});
  EXPECT_EQ(counts.cycles, 5U);
  EXPECT_EQ(counts.dual_issued, 0U);
}

TEST(Pipeline, ThePartnerWaitsForTheResultOfTheFirst) {
  // add @0; the store needs its result @2, so that one cycle has no instruction; stop @3
  const CycleCounts counts = count_cycles({add_one(3, 3), encode("stqd", {3, 0, 100}), kStop});
  EXPECT_EQ(counts.cycles, 4U);
  EXPECT_EQ(counts.dual_issued, 0U);
  EXPECT_EQ(counts.stall(Stall::fixed), 1U);
}

TEST(Pipeline, ShufflesOfOtherDataIssueBackToBack) {
  const auto shuffle = [](std::int32_t target) { return encode("shufb", {target, 3, 4, 5}); };
  // @0 to @3, stop @4
  EXPECT_EQ(count_cycles({shuffle(10), shuffle(11), shuffle(12), shuffle(13), kStop}).cycles, 5U);
}

TEST(Pipeline, ShufflesOfEachOthersResultTakeFourCycles) {
  const std::uint32_t shuffle = encode("shufb", {3, 3, 4, 5});
  // @0, @4, @8, @12; stop @13
  const CycleCounts counts = count_cycles({shuffle, shuffle, shuffle, shuffle, kStop});
  EXPECT_EQ(counts.cycles, 14U);
  EXPECT_EQ(counts.stall(Stall::shuffle), 9U);
}

TEST(Pipeline, NothingIssuesForSixCyclesAfterDoublePrecision) {
  const auto add = [](std::int32_t target) { return encode("dfa", {target, 10, 11}); };
  // @0, @7, @14, @21; stop @28
  const CycleCounts counts = count_cycles({add(3), add(4), add(5), add(6), kStop});
  EXPECT_EQ(counts.cycles, 29U);
  EXPECT_EQ(counts.stall(Stall::double_block), 24U);
  CycleParameters later_cell;
  later_cell.double_block = 0;
  EXPECT_EQ(count_cycles({add(3), add(4), add(5), add(6), kStop}, later_cell).cycles, 5U);
}

TEST(Pipeline, ADoubleIsReadyAfterThirteenCycles) {
  // dfa @0; il @7, six cycles blocked; the add needs the double @13, five cycles more; the stop with it
  const CycleCounts counts =
      count_cycles({encode("dfa", {3, 10, 11}), encode("il", {4, 1}), add_one(5, 3), kStop});
  EXPECT_EQ(counts.cycles, 14U);
  EXPECT_EQ(counts.stall(Stall::double_block), 6U);
  EXPECT_EQ(counts.stall(Stall::floating), 5U);
  EXPECT_EQ(counts.dual_issued, 1U);
}

TEST(Pipeline, ConditionsStoresAndAccumulatorsReadTheirTarget) {
  const std::uint32_t slow = encode("mpy", {3, 4, 5});
  // mpy @0, then $3 @7, the stop @8
  for (const std::uint32_t reader :
       {encode("brz", {3, 4}), encode("stqd", {3, 0, 100}), encode("iohl", {3, 1}), encode("addx", {3, 6, 7}),
        encode("wrch", {SPU_WrEventAck, 3})}) {
    EXPECT_EQ(count_cycles({slow, reader, kStop}).cycles, 9U) << std::hex << reader;
  }
  // mpy @0, with it or after it what does not care, stop
  for (const std::uint32_t other : {encode("nop", {3}), encode("il", {3, 1}), encode("lqd", {3, 0, 100})})
    EXPECT_LE(count_cycles({slow, other, kStop}).cycles, 3U) << std::hex << other;
}

TEST(Pipeline, LoadsWithoutAGapStarveTheFetch) {
  std::vector<std::uint32_t> loads;
  for (std::int32_t i = 0; i < 40; ++i) loads.push_back(load(10 + i));
  TimedMachine spu;
  for (std::uint32_t i = 0; i < 40; ++i) spu.put(4 * i, loads[i]);
  spu.put(160, kStop);
  spu.machine.set_pc(0);
  spu.run_to_stop();
  // 32 loads fill the first line of code @0 to @31; the next line comes 8 cycles late; 8 more, and the stop
  EXPECT_EQ(spu.model.profile().total.cycles, 49U);
  EXPECT_EQ(spu.model.profile().total.stall(Stall::fetch), 8U);

  TimedMachine with_gap;
  for (std::uint32_t i = 0; i < 40; ++i) with_gap.put(4 * i, i == 5 ? encode("nop", {0}) : loads[i]);
  with_gap.put(160, kStop);
  with_gap.machine.set_pc(0);
  with_gap.run_to_stop();
  EXPECT_EQ(with_gap.model.profile().total.stall(Stall::fetch), 0U);
}

TEST(Pipeline, ParametersChangeTheLatencies) {
  CycleParameters slow;
  slow.fixed_latency = 5;
  // @0, @5; stop @6
  EXPECT_EQ(count_cycles({add_one(3, 3), add_one(3, 3), kStop}, slow).cycles, 7U);
}

TEST(Pipeline, CodeThatIsChangedIsTimedAnew) {
  TimedMachine spu;
  spu.count({add_one(3, 3), add_one(3, 3), kStop});  // @0, @2, @3: 4 cycles
  spu.put(4, encode("mpy", {4, 3, 3}));
  spu.put(8, add_one(4, 4));
  spu.put(12, kStop);
  spu.machine.set_pc(0);
  spu.run_to_stop();  // @0, @2, @9, and the stop with it: 10 more
  EXPECT_EQ(spu.model.profile().total.cycles, 14U);
}

}  // namespace
}  // namespace spu_emu::isa
