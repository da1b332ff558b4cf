// Code that changes: by its own stores, by DMA, by other threads.
#include <thread>

#include "test_machine.h"

namespace spu_emu::isa {
namespace {

constexpr std::uint32_t kPatch = 0x4000;  // a quadword of instructions that programs copy into their way

class SelfModifying : public testing::Test {
 protected:
  void put_patch(std::initializer_list<std::uint32_t> words) {
    std::uint32_t address = kPatch;
    for (const std::uint32_t word : words) {
      spu_.put(address, word);
      address += 4;
    }
  }
  TestMachine spu_;
};

TEST_F(SelfModifying, AStoreIsSeenByTheVeryNextInstruction) {
  put_patch({encode("il", {3, 2}), 9, 9, 9});
  for (int turn = 0; turn < 2; ++turn) {
    spu_.program({encode("nop", {0}), encode("nop", {0}), encode("lqa", {4, kPatch}), encode("stqr", {4, 4}),
                  encode("il", {3, 1}), 8});
    EXPECT_EQ(spu_.run_to_stop().code, 9U);
    EXPECT_EQ(spu_.machine.word(3, 0), 2U);
  }
}

TEST_F(SelfModifying, AStoreIntoABlockThatRanBeforeIsSeen) {
  spu_.program({5}, 0x100);
  EXPECT_EQ(spu_.run_to_stop().code, 5U);
  put_patch({6, 0, 0, 0});
  spu_.program({encode("lqa", {4, kPatch}), encode("stqa", {4, 0x100}), encode("bra", {0x100})}, 0x200);
  EXPECT_EQ(spu_.run_to_stop().code, 6U);
}

TEST_F(SelfModifying, AStoreIntoTheMiddleOfALongBlockIsSeenFromItsStart) {
  std::uint32_t address = 0x100;
  for (; address < 0x100 + 4 * 60; address += 4) spu_.put(address, encode("ai", {3, 3, 1}));
  spu_.put(address, 5);
  spu_.machine.set_pc(0x100);
  spu_.run_to_stop();
  EXPECT_EQ(spu_.machine.word(3, 0), 60U);
  put_patch(
      {encode("ai", {3, 3, 1}), encode("ai", {3, 3, 1}), encode("ai", {3, 3, 100}), encode("ai", {3, 3, 1})});
  spu_.program(
      {encode("lqa", {4, kPatch}), encode("stqa", {4, 0x1a0}), encode("il", {3, 0}), encode("bra", {0x100})},
      0x400);
  spu_.run_to_stop();
  EXPECT_EQ(spu_.machine.word(3, 0), 159U);
}

TEST_F(SelfModifying, AProgramMayRewriteItselfInEveryTurnOfALoop) {
  // Adds the immediate of the instruction at 0x20, which every turn makes larger by one.
  spu_.program({encode("il", {5, 100}), encode("ilhu", {6, 0}), encode("iohl", {6, 0x4000}),
                encode("nop", {0}), encode("lqa", {7, 0x20}), encode("a", {7, 7, 6}),
                encode("stqa", {7, 0x20}), encode("nop", {0}), encode("ai", {3, 3, 0}),
                encode("ai", {5, 5, -1}), encode("brnz", {5, -24}), 5});
  spu_.set(6, {});
  spu_.program({encode("nop", {0}), encode("nop", {0}), encode("nop", {0}), encode("nop", {0})});
  spu_.set(5, {100, 0, 0, 0});
  spu_.set(6, {0x4000, 0, 0, 0});
  spu_.machine.set_pc(0);
  EXPECT_EQ(spu_.run_to_stop().code, 5U);
  EXPECT_EQ(spu_.machine.word(3, 0), 100U * 101 / 2);
}

TEST_F(SelfModifying, DataBesideCodeMayBeWrittenWithoutHarm) {
  spu_.program({encode("stqr", {5, 16}), encode("ai", {3, 3, 1}), 5, 7});
  spu_.put(0x10, 8);
  EXPECT_EQ(spu_.run_to_stop().code, 5U);
  EXPECT_EQ(spu_.machine.word(3, 0), 1U);
}

TEST_F(SelfModifying, WhatDmaBringsIsExecuted) {
  spu_.program({5}, 0x1000);
  spu_.run_to_stop();
  const std::uint32_t stop = 6;  // in the order of main memory: words are swapped on the way
  std::memcpy(spu_.main->bytes.data(), &stop, sizeof stop);
  const std::uint64_t ea = spu_.ea();
  spu_.set(10, {0x1000, 0, 0, 0});
  spu_.set(11, {static_cast<std::uint32_t>(ea >> 32), 0, 0, 0});
  spu_.set(12, {static_cast<std::uint32_t>(ea), 0, 0, 0});
  spu_.set(13, {16, 0, 0, 0});
  spu_.set(14, {0x40, 0, 0, 0});
  spu_.program({encode("wrch", {MFC_LSA, 10}), encode("wrch", {MFC_EAH, 11}), encode("wrch", {MFC_EAL, 12}),
                encode("wrch", {MFC_Size, 13}), encode("wrch", {MFC_Cmd, 14}), 1, encode("bra", {0x1000})});
  EXPECT_EQ(spu_.run_to_stop().code, 1U);
  spu_.machine.local_store_written(0x1000, 16);  // as whoever connects machine and MFC does
  EXPECT_EQ(spu_.run_to_stop().code, 6U);
}

TEST_F(SelfModifying, AnotherThreadMayTellOfWritesAtAnyTime) {
  spu_.program({encode("ai", {3, 3, 1}), encode("br", {-4})});
  std::thread other([&] {
    for (std::uint32_t k = 0; k < 1000; ++k) spu_.machine.local_store_written(k * 64, 4096);
    spu_.machine.local_store_written(0xffffff80, 0xffffffff);
    spu_.machine.interrupt();
  });
  EXPECT_EQ(spu_.machine.run(~std::uint64_t{0}).kind, MachineStop::Kind::interrupted);
  other.join();
  EXPECT_LE(spu_.machine.instructions() / 2 - spu_.machine.word(3, 0), 1U);
}

}  // namespace
}  // namespace spu_emu::isa
