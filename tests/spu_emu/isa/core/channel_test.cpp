// Channel instructions and interrupts on the machine.
#include "test_machine.h"

namespace spu_emu::isa {
namespace {

TEST(ChannelInstructions, ReadWriteAndCount) {
  TestMachine spu;
  const std::uint32_t message = 42;
  spu.channels.write_in_mailbox(&message, 1);
  spu.set(6, {7, 7, 7, 7});
  spu.set(4, {9, 9, 9, 9});
  spu.program({encode("rchcnt", {3, SPU_RdInMbox}), encode("rdch", {4, SPU_RdInMbox}),
               encode("rchcnt", {5, SPU_RdInMbox}), encode("wrch", {SPU_WrOutMbox, 6}), kStop});
  spu.run_to_stop();
  EXPECT_EQ(spu.reg(3), (Words{1, 0, 0, 0}));
  EXPECT_EQ(spu.reg(4), (Words{42, 0, 0, 0}));
  EXPECT_EQ(spu.reg(5), Words{});
  std::uint32_t answer = 0;
  EXPECT_EQ(spu.channels.read_out_mailbox(&answer, 1), 1U);
  EXPECT_EQ(answer, 7U);
}

TEST(ChannelInstructions, MoveDataByDma) {
  TestMachine spu;
  const std::uint64_t ea = spu.ea(0x100);
  const std::uint32_t words[] = {
      0x2000, static_cast<std::uint32_t>(ea >> 32), static_cast<std::uint32_t>(ea), 128, 3, 0x40, 8, 2};
  unsigned reg = 10;
  for (const std::uint32_t word : words) spu.set(reg++, {word, 0, 0, 0});
  spu.program({encode("wrch", {MFC_LSA, 10}), encode("wrch", {MFC_EAH, 11}), encode("wrch", {MFC_EAL, 12}),
               encode("wrch", {MFC_Size, 13}), encode("wrch", {MFC_TagID, 14}), encode("wrch", {MFC_Cmd, 15}),
               encode("wrch", {MFC_WrTagMask, 16}), encode("wrch", {MFC_WrTagUpdate, 17}),
               encode("rdch", {3, MFC_RdTagStat}), kStop});
  spu.run_to_stop();
  EXPECT_EQ(spu.machine.word(3, 0), 8U);
  std::uint32_t first = 0;
  std::memcpy(&first, spu.main->bytes.data() + 0x100, sizeof first);
  EXPECT_EQ(spu.get(0x2000), first) << "words keep their value on the way";
}

TEST(ChannelInstructions, FaultAtTheirOwnAddressAndDoNotCount) {
  TestMachine spu;
  spu.set(5, {17, 0, 0, 0});  // a size that no MFC takes
  spu.set(6, {0x40, 0, 0, 0});
  spu.program({encode("il", {3, 1}), encode("wrch", {MFC_Size, 5}), encode("il", {3, 2}),
               encode("wrch", {MFC_Cmd, 6}), kStop},
              0x80);
  expect_fault(Rule::transfer_size, [&] { spu.machine.run(100); });
  EXPECT_EQ(spu.machine.pc(), 0x8cU);
  EXPECT_EQ(spu.machine.instructions(), 3U);
  EXPECT_EQ(spu.machine.word(3, 0), 2U);
  expect_fault(Rule::transfer_size, [&] { spu.machine.run(100); });
}

TEST(ChannelInstructions, OfUnknownChannelsFault) {
  TestMachine spu;
  spu.program({encode("rdch", {3, 64})});
  expect_fault(Rule::channel, [&] { spu.machine.run(100); });
  spu.program({encode("wrch", {5, 3})});
  expect_fault(Rule::channel, [&] { spu.machine.run(100); });
}

TEST(ChannelInstructions, SpecialRegistersReadAsZero) {
  TestMachine spu;
  spu.set(3, {1, 1, 1, 1});
  spu.program({encode("mtspr", {5, 3}), encode("mfspr", {3, 5}), kStop});
  spu.run_to_stop();
  EXPECT_EQ(spu.reg(3), Words{});
}

/// At 0 a handler that counts in $3, acknowledges its event and returns; at 0x100 a program that enables
/// interrupts and counts in $4 until the handler was there.
class Interrupts : public testing::Test {
 protected:
  void SetUp() override {
    spu_.set(20, {MFC_SIGNAL_NOTIFY_1_EVENT, 0, 0, 0});
    spu_.set(6, {0x104, 0, 0, 0});
    spu_.program({encode("ai", {3, 3, 1}), encode("rdch", {21, SPU_RdEventStat}),
                  encode("wrch", {SPU_WrEventAck, 20}), encode("rdch", {22, SPU_RdMachStat}),
                  encode("rdch", {24, SPU_RdSRR0}), encode("iret", {0}) | kInterruptsOn});
    spu_.program({encode("bi", {6}) | kInterruptsOn, encode("rdch", {23, SPU_RdMachStat}),
                  encode("ai", {4, 4, 1}), encode("brz", {3, -4}), 5},
                 0x100);
    spu_.channels.write(SPU_WrEventMask, MFC_SIGNAL_NOTIFY_1_EVENT);
  }
  TestMachine spu_;
};

TEST_F(Interrupts, CallTheHandlerAtZeroOnceForAnEvent) {
  EXPECT_EQ(spu_.machine.run(1000).kind, MachineStop::Kind::budget);
  EXPECT_EQ(spu_.machine.word(3, 0), 0U);
  spu_.channels.signal(0, 1);
  EXPECT_EQ(spu_.run_to_stop().code, 5U);
  EXPECT_EQ(spu_.machine.word(3, 0), 1U);
  EXPECT_EQ(spu_.machine.word(21, 0), std::uint32_t{MFC_SIGNAL_NOTIFY_1_EVENT});
  EXPECT_EQ(spu_.machine.word(22, 0), 0U) << "interrupts are disabled in the handler";
  EXPECT_EQ(spu_.machine.word(23, 0), 1U);
  EXPECT_EQ(spu_.machine.word(24, 0) & ~0xcU, 0x100U);
}

TEST_F(Interrupts, AreNotTakenWhileDisabled) {
  spu_.channels.signal(0, 1);
  spu_.put(0x100, encode("bi", {6}) | kInterruptsOff);
  EXPECT_EQ(spu_.machine.run(1000).kind, MachineStop::Kind::budget);
  EXPECT_EQ(spu_.machine.word(3, 0), 0U);
  EXPECT_EQ(spu_.machine.word(23, 0), 0U);
}

}  // namespace
}  // namespace spu_emu::isa
