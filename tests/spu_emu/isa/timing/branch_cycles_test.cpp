// Branches and hints: programs whose cycles are counted by hand. "@3" is the cycle of an issue.
#include "timed_machine.h"

namespace spu_emu::isa {
namespace {

TEST(BranchCycles, ALoopWithoutAHintMissesAtEveryTurn) {
  TimedMachine spu;
  spu.set(3, {10, 0, 0, 0});
  // A turn: add @0, branch @2 when the sum is there, 18 cycles for the miss, the next add @21. Nine turns
  // like that; in the tenth the branch falls through as predicted: 9 * 21 + 3, and the stop.
  const CycleCounts counts = spu.count({encode("ai", {3, 3, -1}), encode("brnz", {3, -4}), kStop});
  EXPECT_EQ(counts.cycles, 193U);
  EXPECT_EQ(counts.stall(Stall::branch_miss), 162U);
  EXPECT_EQ(counts.stall(Stall::fixed), 10U);
}

TEST(BranchCycles, AHintedLoopMissesOnlyAtItsEnd) {
  const std::uint32_t lnop = encode("lnop");
  TimedMachine spu;
  spu.set(3, {10, 0, 0, 0});
  // hint @0, lnop @1; the first turn is five pairs, @2 to @6. The hint is ready for the next one @16: nine
  // cycles late. Eight more turns of five cycles, @16 to @55, and the last one @56 to @60, whose branch falls
  // through against the hint: 18 cycles, the stop @79.
  const CycleCounts counts = spu.count({encode("hbrr", {0x2c, 0x08}), lnop,  //
                                        encode("ai", {3, 3, -1}), lnop,      //
                                        encode("ai", {4, 4, 1}), lnop,       //
                                        encode("ai", {5, 5, 1}), lnop,       //
                                        encode("ai", {6, 6, 1}), lnop,       //
                                        encode("ai", {7, 7, 1}), encode("brnz", {3, 0x08 - 0x2c}), kStop});
  EXPECT_EQ(counts.cycles, 80U);
  EXPECT_EQ(counts.stall(Stall::late_hint), 9U);
  EXPECT_EQ(counts.stall(Stall::branch_miss), 18U);
  EXPECT_EQ(counts.dual_issued, 50U);
}

TEST(BranchCycles, AHintTooCloseToItsBranchIsNotSeen) {
  TimedMachine spu;
  spu.put(0x20, kStop);
  // hint @0, lnop @1, branch @2, 18 cycles for the miss, the stop @21
  const CycleCounts counts = spu.count({encode("hbrr", {8, 0x20}), encode("lnop"), encode("br", {0x20 - 8})});
  EXPECT_EQ(counts.cycles, 22U);
  EXPECT_EQ(counts.stall(Stall::branch_miss), 18U);
}

/// `first`, fifteen cycles of no-operations, and a branch to $6 with a stop.
CycleCounts count_far_branch(std::uint32_t first) {
  TimedMachine spu;
  spu.set(6, {0x100, 0, 0, 0});
  spu.put(0x100, kStop);
  spu.put(0, first);
  for (std::uint32_t at = 4; at < 0x40; at += 4) spu.put(at, encode("nop", {0}));
  spu.put(0x40, encode("bi", {6}));
  spu.machine.set_pc(0);
  spu.run_to_stop();
  return spu.model.profile().total;
}

TEST(BranchCycles, AHintInTimeMakesABranchFree) {
  // hint @0, no-operations @1 to @15, branch @16, stop @17
  EXPECT_EQ(count_far_branch(encode("hbr", {0x40, 6})).cycles, 18U);
  // The same with the target in the instruction.
  EXPECT_EQ(count_far_branch(encode("hbra", {0x40, 0x100})).cycles, 18U);
}

TEST(BranchCycles, AHintOfAnotherBranchOrTargetIsNone) {
  for (const std::uint32_t other :
       {encode("lnop"), encode("hbra", {0x44, 0x100}), encode("hbra", {0x40, 0x104})}) {
    // branch @16, 18 cycles for the miss, the stop @35
    EXPECT_EQ(count_far_branch(other).cycles, 36U) << std::hex << other;
  }
}

TEST(BranchCycles, ACallsReturnAddressIsReadyAfterFourCycles) {
  // call @0, 18 cycles for the miss, the add @19 does not wait; the stop, second of its pair, with it
  EXPECT_EQ(count_cycles({encode("brsl", {0, 8}), kStop, encode("ai", {3, 0, 0}), kStop}).cycles, 20U);
  CycleParameters quick;
  quick.branch_miss = 0;
  // call @0, the add needs the link register @4
  EXPECT_EQ(count_cycles({encode("brsl", {0, 8}), kStop, encode("ai", {3, 0, 0}), kStop}, quick).cycles, 5U);
}

}  // namespace
}  // namespace spu_emu::isa
