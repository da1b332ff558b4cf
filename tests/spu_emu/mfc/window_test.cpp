// Effective addresses that are another SPE: its local store and its problem state registers.
#include "mfc/spe_directory.h"
#include "test_spu.h"

namespace spu_emu {
namespace {

/// An SPE with a window of effective addresses during the test.
class WindowSpu : public TestSpu {
 public:
  explicit WindowSpu(std::uint64_t number, WordOrder order = WordOrder::same)
      : TestSpu(DmaMode::eager, 1, order), base((0x100 + number) << 32U) {
    SpeDirectory::instance().add({base, kLocalStoreSize, &store, &channels});
  }
  ~WindowSpu() { SpeDirectory::instance().remove(base); }
  WindowSpu(const WindowSpu&) = delete;
  WindowSpu& operator=(const WindowSpu&) = delete;

  std::uint64_t base;
};

TEST(Window, local_store_to_local_store_moves_bytes_both_ways) {
  WindowSpu one(1);
  WindowSpu two(2);
  one.local->bytes[0x1004] = std::byte{0x44};
  one.dma(MFC_PUT_CMD, 0x1000, two.base + 0x2000, 64, 0);
  EXPECT_EQ(two.peek(0x2004), std::byte{0x44});
  two.local->bytes[0x3001] = std::byte{0x55};
  one.dma(MFC_GET_CMD, 0x5000, two.base + 0x3000, 16384, 0);
  EXPECT_EQ(one.peek(0x5001), std::byte{0x55});
}

TEST(Window, moves_between_local_stores_of_one_order_never_swap) {
  WindowSpu one(1, WordOrder::swapped);
  WindowSpu two(2, WordOrder::swapped);
  one.local->bytes[0x1001] = std::byte{0x44};
  one.dma(MFC_PUT_CMD, 0x1000, two.base + 0x2000, 16, 0);
  EXPECT_EQ(two.peek(0x2001), std::byte{0x44});
}

TEST(Window, an_address_beyond_the_other_local_store_is_refused) {
  WindowSpu one(1);
  WindowSpu two(2);
  const std::string text = expect_fault(
      Rule::effective_address, [&] { one.dma(MFC_PUT_CMD, 0x1000, two.base + kLocalStoreSize - 16, 64, 0); });
  EXPECT_NE(text.find("other SPE"), std::string::npos) << text;
}

TEST(Window, only_its_local_store_and_problem_state_are_more_than_main_memory) {
  const WindowSpu spu(1);
  EXPECT_TRUE(SpeDirectory::may_be_window(spu.base + kLocalStoreSize - 1));
  EXPECT_FALSE(SpeDirectory::may_be_window(spu.base + kLocalStoreSize));
  EXPECT_FALSE(SpeDirectory::may_be_window(spu.base + kProblemStateOffset - 1));
  EXPECT_TRUE(SpeDirectory::may_be_window(spu.base + kProblemStateOffset));
}

TEST(Window, sndsig_writes_the_signal_register_of_another_spe) {
  WindowSpu one(1);
  WindowSpu two(2);
  const std::uint32_t value = 0xcafe;
  for (const std::uint32_t opcode : {MFC_SNDSIG_CMD, MFC_SNDSIGF_CMD, MFC_SNDSIGB_CMD}) {
    std::memcpy(one.local->bytes.data() + 0x100c, &value, 4);
    one.dma(opcode, 0x100c, two.base + kProblemStateOffset + kSignal1Area + 0xc, 4, 0);
    EXPECT_EQ(two.channels.read(SPU_RdSigNotify1), 0xcafeU);
    one.dma(opcode, 0x100c, two.base + kProblemStateOffset + kSignal2Area + 0xc, 4, 0);
    EXPECT_EQ(two.channels.read(SPU_RdSigNotify2), 0xcafeU);
  }
}

TEST(Window, a_put_reaches_the_in_mailbox_and_a_get_the_out_mailbox_of_another_spe) {
  WindowSpu one(1);
  WindowSpu two(2);
  const std::uint32_t value = 77;
  std::memcpy(one.local->bytes.data() + 0x100c, &value, 4);
  one.dma(MFC_PUT_CMD, 0x100c, two.base + kProblemStateOffset + kControlArea + 0xc, 4, 0);
  EXPECT_EQ(two.channels.read(SPU_RdInMbox), 77U);
  two.channels.write(SPU_WrOutMbox, 78);
  one.dma(MFC_GET_CMD, 0x1014, two.base + kProblemStateOffset + kControlArea + 0x14, 4, 0);
  std::uint32_t status = 0;
  std::memcpy(&status, one.local->bytes.data() + 0x1014, 4);
  EXPECT_EQ(status, (4U << 8U) | 1U);
  one.dma(MFC_GET_CMD, 0x1014 - 16, two.base + kProblemStateOffset + kControlArea + 0x4, 4, 0);
  std::uint32_t message = 0;
  std::memcpy(&message, one.local->bytes.data() + 0x1004, 4);
  EXPECT_EQ(message, 78U);
}

TEST(Window, other_registers_and_sizes_are_refused) {
  WindowSpu one(1);
  WindowSpu two(2);
  const std::uint64_t registers = two.base + kProblemStateOffset;
  expect_fault(Rule::register_access,
               [&] { one.dma(MFC_PUT_CMD, 0x1000, registers + kMfcCommandArea, 4, 0); });
  expect_fault(Rule::register_access, [&] { one.dma(MFC_PUT_CMD, 0x1000, registers + kSignal1Area, 16, 0); });
  expect_fault(Rule::register_access,
               [&] { one.dma(MFC_GET_CMD, 0x100c, registers + kSignal1Area + 0xc, 4, 0); });
}

TEST(Window, atomic_commands_work_on_a_line_of_another_local_store) {
  WindowSpu one(1);
  WindowSpu two(2);
  one.dma(MFC_GETLLAR_CMD, 0x1000, two.base + 0x2000, 128, 0);
  one.local->bytes[0x1000] = std::byte{0x31};
  one.channels.read(MFC_RdAtomicStat);
  one.dma(MFC_PUTLLC_CMD, 0x1000, two.base + 0x2000, 128, 0);
  EXPECT_EQ(one.channels.read(MFC_RdAtomicStat), 0U);
  EXPECT_EQ(two.peek(0x2000), std::byte{0x31});
}

}  // namespace
}  // namespace spu_emu
