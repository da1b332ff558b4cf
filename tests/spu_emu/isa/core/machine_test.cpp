#include "spu_emu/intrinsics/float_mode.h"
// How a run ends, what it counts, and what may happen to it from outside.
#include <chrono>
#include <thread>

#include "test_machine.h"

namespace spu_emu::isa {
namespace {

using Kind = MachineStop::Kind;

TEST(Machine, StopsWithTheTypeAndTheAddressAfterIt) {
  TestMachine spu;
  spu.program({encode("il", {3, 1}), 0x2101}, 0x80);
  const MachineStop stop = spu.machine.run(100);
  EXPECT_EQ(stop.kind, Kind::stop);
  EXPECT_EQ(stop.code, 0x2101U);
  EXPECT_EQ(stop.pc, 0x88U);
  EXPECT_EQ(spu.machine.pc(), 0x88U);
  EXPECT_EQ(spu.machine.instructions(), 2U);
}

TEST(Machine, StopsWithDependenciesByTheCodeOfAllOnes) {
  TestMachine spu;
  spu.program({encode("stopd", {1, 2, 3})});
  EXPECT_EQ(spu.run_to_stop().code, 0x3fffU);
}

TEST(Machine, GoesOnAfterAStop) {
  TestMachine spu;
  spu.program({1, 2, 3});
  for (const std::uint32_t code : {1U, 2U, 3U}) EXPECT_EQ(spu.run_to_stop().code, code);
}

TEST(Machine, NamesAWordThatIsNoInstruction) {
  constexpr std::uint32_t kNothing = 0x00800000;
  TestMachine spu;
  spu.program({encode("nop", {0}), kNothing});
  const MachineStop stop = spu.machine.run(100);
  EXPECT_EQ(stop.kind, Kind::illegal);
  EXPECT_EQ(stop.code, kNothing);
  EXPECT_EQ(stop.pc, 4U);
  EXPECT_EQ(spu.machine.pc(), 4U);
  EXPECT_EQ(spu.machine.instructions(), 1U) << "it was not executed";
}

TEST(Machine, HaltsWhereAConditionHolds) {
  struct Case {
    std::uint32_t instruction;
    bool halts;
  };
  TestMachine spu;
  spu.set(4, {5, 0, 0, 0});
  spu.set(5, {0xfffffffe, 0, 0, 0});
  const Case cases[] = {{encode("heq", {0, 4, 4}), true},   {encode("heq", {0, 4, 5}), false},
                        {encode("heqi", {0, 4, 5}), true},  {encode("heqi", {0, 4, 6}), false},
                        {encode("hgt", {0, 4, 5}), true},   {encode("hgt", {0, 5, 4}), false},
                        {encode("hgti", {0, 4, -2}), true}, {encode("hgti", {0, 5, -2}), false},
                        {encode("hlgt", {0, 5, 4}), true},  {encode("hlgt", {0, 4, 5}), false},
                        {encode("hlgti", {0, 4, 4}), true}, {encode("hlgti", {0, 4, -2}), false}};
  for (const Case& c : cases) {
    spu.program({encode("nop", {0}), c.instruction, kStop});
    const MachineStop stop = spu.machine.run(100);
    EXPECT_EQ(stop.kind, c.halts ? Kind::halt : Kind::stop) << std::hex << c.instruction;
    EXPECT_EQ(stop.pc, c.halts ? 4U : 12U);
  }
}

TEST(Machine, ExecutesExactlyItsBudget) {
  TestMachine spu;
  // Counts in $3, with things in between that end blocks and things that are decoded to nothing.
  spu.program({encode("ai", {3, 3, 1}), encode("nop", {0}), encode("brz", {5, 8}), encode("lnop", {}),
               encode("ai", {3, 3, 1}), encode("rchcnt", {4, MFC_Cmd}), encode("br", {-24})});
  std::uint64_t executed = 0;
  for (std::uint64_t budget = 0; budget < 300; ++budget) {
    EXPECT_EQ(spu.machine.run(budget).kind, Kind::budget);
    executed += budget;
    EXPECT_EQ(spu.machine.instructions(), executed);
  }
  // Six of the seven words are executed in every turn, two of them count.
  const std::uint64_t rest[] = {0, 1, 1, 1, 2, 2};
  EXPECT_EQ(spu.machine.word(3, 0), executed / 6 * 2 + rest[executed % 6]);
}

TEST(Machine, StepsOneInstructionAtATime) {
  TestMachine spu;
  spu.program(
      {encode("nop", {0}), encode("il", {3, 5}), encode("br", {8}), kStop, encode("il", {3, 6}), kStop});
  const std::uint32_t pcs[] = {4, 8, 16, 20};
  for (const std::uint32_t pc : pcs) EXPECT_EQ(spu.machine.run(1).pc, pc);
  EXPECT_EQ(spu.machine.word(3, 0), 6U);
  EXPECT_EQ(spu.machine.run(1).kind, Kind::stop);
}

TEST(Machine, IsAsNewAfterAReset) {
  TestMachine spu;
  spu.program({encode("il", {3, 5}), encode("fscrwr", {0, 3}), kStop});
  spu.run_to_stop();
  spu.machine.reset();
  EXPECT_EQ(spu.machine.pc(), 0U);
  EXPECT_EQ(spu.reg(3), Words{});
  EXPECT_EQ(spu.machine.fpscr(0), 0U);
  EXPECT_EQ(spu.machine.instructions(), 0U);
}

TEST(Machine, LeavesTheThreadsFloatingPointModeAsItWas) {
  TestMachine spu;
  const unsigned before = float_control();
  spu.program({encode("dfa", {3, 3, 3}), encode("fa", {3, 3, 3}), kStop});
  spu.run_to_stop();
  EXPECT_EQ(float_control(), before);
  spu.program({encode("rdch", {3, 60})});
  EXPECT_THROW(spu.machine.run(5), Fault);
  EXPECT_EQ(float_control(), before);
}

TEST(Machine, IsInterruptedFromAnotherThread) {
  TestMachine spu;
  spu.program({encode("br", {0})});
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    spu.machine.interrupt();
  });
  EXPECT_EQ(spu.machine.run(~std::uint64_t{0}).kind, Kind::interrupted);
  other.join();
  EXPECT_EQ(spu.machine.run(10).kind, Kind::budget) << "one interrupt ends one run";
}

TEST(Machine, TakesAnInterruptBeforeItsFirstInstruction) {
  TestMachine spu;
  spu.program({encode("br", {0})});
  spu.machine.interrupt();
  EXPECT_EQ(spu.machine.run(10).kind, Kind::interrupted);
  EXPECT_EQ(spu.machine.instructions(), 0U);
}

}  // namespace
}  // namespace spu_emu::isa
