// Branches, links and loads of the program counter.
#include "test_machine.h"

namespace spu_emu::isa {
namespace {

using Kind = MachineStop::Kind;

/// Runs `branch` at 0x100 and tells where it led: targets are stops with their own codes.
class Branches : public testing::Test {
 protected:
  /// The code of the stop that was reached: 1 at 0x104, 2 at 0x200, 3 at 0.
  std::uint32_t reached(std::uint32_t branch) {
    spu_.program({branch, 1}, 0x100);
    spu_.put(0x200, 2);
    spu_.put(0, 3);
    spu_.machine.set_pc(0x100);
    return spu_.run_to_stop().code;
  }
  TestMachine spu_;
};

TEST_F(Branches, GoToRelativeAndAbsoluteAddresses) {
  EXPECT_EQ(reached(encode("br", {0x100})), 2U);
  EXPECT_EQ(reached(encode("br", {-0x100})), 3U);
  EXPECT_EQ(reached(encode("bra", {0x200})), 2U);
  EXPECT_EQ(reached(encode("br", {4})), 1U);
}

TEST_F(Branches, WrapAtTheEndOfTheLocalStore) {
  spu_.put(0x3fffc, encode("br", {0x204}));
  spu_.put(0x200, 7);
  spu_.machine.set_pc(0x3fffc);
  EXPECT_EQ(spu_.run_to_stop().code, 7U);
  spu_.program({encode("br", {-0x10})}, 0);
  spu_.put(0x3fff0, 8);
  EXPECT_EQ(spu_.run_to_stop().code, 8U);
}

TEST_F(Branches, GoOnAtZeroAfterTheLastInstruction) {
  spu_.put(0, 5);
  spu_.put(0x3fffc, encode("il", {4, 9}));
  spu_.machine.set_pc(0x3fffc);
  EXPECT_EQ(spu_.run_to_stop().code, 5U);
  EXPECT_EQ(spu_.machine.word(4, 0), 9U);
}

TEST_F(Branches, KeepTheReturnAddressInThePreferredSlotAlone) {
  spu_.set(4, {7, 7, 7, 7});
  EXPECT_EQ(reached(encode("brsl", {4, 0x100})), 2U);
  EXPECT_EQ(spu_.reg(4), (Words{0x104, 0, 0, 0}));
  EXPECT_EQ(reached(encode("brasl", {5, 0x200})), 2U);
  EXPECT_EQ(spu_.reg(5), (Words{0x104, 0, 0, 0}));
}

TEST_F(Branches, DependOnTheWordOrHalfwordOfThePreferredSlot) {
  struct Case {
    Words value;
    const char* taken[2];
    const char* not_taken[2];
  };
  const Case cases[] = {{{0, 1, 1, 1}, {"brz", "brhz"}, {"brnz", "brhnz"}},
                        {{0x10000, 0, 0, 0}, {"brnz", "brhz"}, {"brz", "brhnz"}},
                        {{0x8000, 0, 0, 0}, {"brnz", "brhnz"}, {"brz", "brhz"}}};
  for (const Case& c : cases) {
    spu_.set(4, c.value);
    for (const char* name : c.taken) EXPECT_EQ(reached(encode(name, {4, 0x100})), 2U) << name;
    for (const char* name : c.not_taken) EXPECT_EQ(reached(encode(name, {4, 0x100})), 1U) << name;
  }
}

TEST_F(Branches, ToRegistersIgnoreAllButTheAddressBits) {
  spu_.set(6, {0xfffc0203, 0, 0, 0});
  EXPECT_EQ(reached(encode("bi", {6})), 2U);
  EXPECT_EQ(reached(encode("bisl", {4, 6})), 2U);
  EXPECT_EQ(spu_.reg(4), (Words{0x104, 0, 0, 0}));
  EXPECT_EQ(reached(encode("bisl", {6, 6})), 2U) << "the target is read before the link is written";
}

TEST_F(Branches, ToRegistersDependOnConditionsToo) {
  spu_.set(6, {0x200, 0, 0, 0});
  spu_.set(4, {0x10000, 0, 0, 0});
  EXPECT_EQ(reached(encode("biz", {4, 6})), 1U);
  EXPECT_EQ(reached(encode("binz", {4, 6})), 2U);
  EXPECT_EQ(reached(encode("bihz", {4, 6})), 2U);
  EXPECT_EQ(reached(encode("bihnz", {4, 6})), 1U);
}

TEST_F(Branches, OnEventsLinkAlwaysAndGoOnlyWhenOneWaits) {
  spu_.set(6, {0x200, 0, 0, 0});
  EXPECT_EQ(reached(encode("bisled", {4, 6})), 1U);
  EXPECT_EQ(spu_.reg(4), (Words{0x104, 0, 0, 0}));
  spu_.channels.write(SPU_WrEventMask, MFC_SIGNAL_NOTIFY_1_EVENT);
  spu_.channels.signal(0, 1);
  EXPECT_EQ(reached(encode("bisled", {4, 6})), 2U);
}

TEST_F(Branches, HintsDoNothing) {
  spu_.set(6, {0x200, 0, 0, 0});
  EXPECT_EQ(reached(encode("hbr", {0, 6})), 1U);
  EXPECT_EQ(reached(encode("hbra", {0, 0x200})), 1U);
  EXPECT_EQ(reached(encode("hbrr", {0, 0x100})), 1U);
}

}  // namespace
}  // namespace spu_emu::isa
