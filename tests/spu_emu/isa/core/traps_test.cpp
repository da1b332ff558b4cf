// Who is asked before instructions: which, with what around them, and what a machine without him does.
#include <functional>
#include <set>
#include <vector>

#include "isa/core/instruction_traps.h"
#include "test_machine.h"

namespace spu_emu::isa {
namespace {

using Kind = MachineStop::Kind;

class Traps final : public InstructionTraps {
 public:
  std::set<std::uint32_t> wanted;
  std::vector<std::uint32_t> came;
  std::function<bool(std::uint32_t)> on_come = [](std::uint32_t) { return true; };
  std::function<void()> on_attention = [] {};

 private:
  bool wants(std::uint32_t pc, std::uint32_t) const override { return wanted.contains(pc); }
  bool come(std::uint32_t pc) override {
    came.push_back(pc);
    return on_come(pc);
  }
  void attend() override { on_attention(); }
};

/// Counts r3 down from 5 in a loop at 4, and stops.
void load_loop(TestMachine& spu) {
  spu.program({encode("il", {3, 5}), encode("ai", {3, 3, -1}), encode("ai", {4, 4, 2}),
               encode("brnz", {3, -8}), 0x2101});
}

TEST(Traps, are_asked_before_the_instructions_that_they_want_and_no_others) {
  TestMachine spu;
  Traps traps;
  traps.wanted = {8};
  spu.machine.set_traps(traps);
  load_loop(spu);
  std::vector<std::uint32_t> counted;
  traps.on_come = [&](std::uint32_t) {
    counted.push_back(spu.machine.word(3, 0));
    return true;
  };
  spu.run_to_stop();
  EXPECT_EQ(traps.came, (std::vector<std::uint32_t>{8, 8, 8, 8, 8}));
  EXPECT_EQ(counted, (std::vector<std::uint32_t>{4, 3, 2, 1, 0}));
}

TEST(Traps, find_the_machine_where_it_is_before_the_instruction) {
  TestMachine spu;
  Traps traps;
  traps.wanted = {12};
  spu.machine.set_traps(traps);
  load_loop(spu);
  std::vector<std::uint64_t> executed;
  traps.on_come = [&](std::uint32_t pc) {
    EXPECT_EQ(spu.machine.pc(), pc);
    executed.push_back(spu.machine.instructions());
    return true;
  };
  spu.run_to_stop();
  EXPECT_EQ(executed, (std::vector<std::uint64_t>{3, 6, 9, 12, 15}));
  EXPECT_EQ(spu.machine.instructions(), 17U) << "1 before the loop, 15 in it, the stop";
}

TEST(Traps, run_with_the_rounding_of_the_host) {
  TestMachine spu;
  Traps traps;
  traps.wanted = {0};
  spu.machine.set_traps(traps);
  load_loop(spu);
  const FloatControl host = float_control();
  FloatControl seen{};
  traps.on_come = [&](std::uint32_t) {
    seen = float_control();
    return true;
  };
  spu.run_to_stop();
  EXPECT_EQ(seen, host);
}

TEST(Traps, may_want_other_instructions_from_where_they_stand) {
  TestMachine spu;
  Traps traps;
  traps.wanted = {4};
  spu.machine.set_traps(traps);
  load_loop(spu);
  traps.on_come = [&](std::uint32_t) {
    if (traps.came.size() > 1) return true;
    traps.wanted = {8, 16};
    spu.machine.decode_again();
    return false;
  };
  spu.run_to_stop();
  EXPECT_EQ(traps.came, (std::vector<std::uint32_t>{4, 8, 8, 8, 8, 8, 16}));
  EXPECT_EQ(spu.machine.instructions(), 17U) << "none was executed twice or left out";
  EXPECT_EQ(spu.reg(4)[0], 10U);
}

TEST(Traps, come_once_more_for_an_instruction_that_is_decoded_anew_and_still_wanted) {
  TestMachine spu;
  Traps traps;
  traps.wanted = {0};
  spu.machine.set_traps(traps);
  load_loop(spu);
  traps.on_come = [&](std::uint32_t) {
    if (traps.came.size() == 1) spu.machine.decode_again();
    return traps.came.size() != 1;
  };
  spu.run_to_stop();
  EXPECT_EQ(traps.came, (std::vector<std::uint32_t>{0, 0}));
}

TEST(Traps, do_not_change_what_a_budget_allows) {
  for (std::uint64_t budget = 0; budget <= 17; ++budget) {
    TestMachine spu;
    Traps traps;
    traps.wanted = {0, 4, 8, 12, 16};
    spu.machine.set_traps(traps);
    load_loop(spu);
    EXPECT_EQ(spu.machine.run(budget).kind, budget == 17 ? Kind::stop : Kind::budget);
    EXPECT_EQ(spu.machine.instructions(), budget);
    EXPECT_EQ(traps.came.size(), budget);
  }
}

TEST(Traps, are_asked_for_code_that_the_program_writes_itself) {
  TestMachine spu;
  Traps traps;
  traps.wanted = {0x100};
  spu.machine.set_traps(traps);
  spu.set(5, {0x2102, 0, 0, 0});
  spu.program({encode("stqa", {5, 0x100}), encode("bra", {0x100})});
  EXPECT_EQ(spu.run_to_stop().code, 0x2102U);
  EXPECT_EQ(traps.came, (std::vector<std::uint32_t>{0x100}));
}

TEST(Traps, attend_between_blocks_when_somebody_asks) {
  TestMachine spu;
  Traps traps;
  spu.machine.set_traps(traps);
  spu.program({encode("nop", {0}), encode("br", {-4})});
  int attended = 0;
  traps.on_attention = [&] {
    ++attended;
    EXPECT_EQ(spu.machine.pc() % 8, 0U);
    spu.machine.interrupt();
  };
  spu.machine.ask_for_attention();
  EXPECT_EQ(spu.machine.run(1'000'000).kind, Kind::interrupted);
  EXPECT_EQ(attended, 1);
  EXPECT_EQ(spu.machine.run(1'000).kind, Kind::budget) << "asked once, attended once";
  EXPECT_EQ(attended, 1);
}

}  // namespace
}  // namespace spu_emu::isa
