// Mailboxes and signal registers, from both sides.
#include <thread>

#include "test_spu.h"

namespace spu_emu {
namespace {

TEST(Mailbox, is_read_in_the_order_of_writing_and_full_at_its_capacity) {
  Mailbox box(4);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_TRUE(box.try_write(i));
  EXPECT_FALSE(box.try_write(9));
  EXPECT_EQ(box.space(), 0U);
  std::uint32_t message = 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(box.try_read(message));
    EXPECT_EQ(message, i);
  }
  EXPECT_FALSE(box.try_read(message));
}

TEST(Mailbox, a_raw_write_to_a_full_box_overwrites_the_newest_message) {
  Mailbox box(4);
  for (std::uint32_t i = 1; i <= 5; ++i) box.write_over(i);
  std::uint32_t message = 0;
  for (const std::uint32_t expected : {1U, 2U, 3U, 5U}) {
    EXPECT_TRUE(box.try_read(message));
    EXPECT_EQ(message, expected);
  }
}

TEST(Mailbox, the_three_boxes_hold_four_one_and_one) {
  TestSpu spu;
  EXPECT_EQ(spu.channels.in_mailbox().space(), 4U);
  EXPECT_EQ(spu.channels.count(SPU_WrOutMbox), 1U);
  EXPECT_EQ(spu.channels.count(SPU_WrOutIntrMbox), 1U);
  const std::array<std::uint32_t, 6> messages{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(spu.channels.write_in_mailbox(messages.data(), 6), 4U);
  EXPECT_EQ(spu.channels.count(SPU_RdInMbox), 4U);
  EXPECT_EQ(spu.channels.read(SPU_RdInMbox), 1U);
  EXPECT_EQ(spu.channels.count(SPU_RdInMbox), 3U);
  spu.channels.write(SPU_WrOutMbox, 7);
  EXPECT_EQ(spu.channels.count(SPU_WrOutMbox), 0U);
  std::uint32_t out = 0;
  EXPECT_EQ(spu.channels.read_out_mailbox(&out, 1), 1U);
  EXPECT_EQ(out, 7U);
  EXPECT_EQ(spu.channels.read_out_mailbox(&out, 1), 0U);
}

TEST(Mailbox, the_spu_blocks_on_an_empty_in_box_and_on_full_out_boxes) {
  TestSpu spu;
  std::thread host([&] {
    for (std::uint32_t i = 0; i < 100; ++i) {
      std::uint32_t answer = 0;
      if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      spu.channels.write_in_mailbox(&i, 1);
      spu.channels.changed().wait([&] { return spu.channels.read_out_mailbox(&answer, 1) == 1; });
      EXPECT_EQ(answer, i + 1);
      if (i % 10 == 5) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      spu.channels.changed().wait([&] { return spu.channels.read_out_mailbox(&answer, 1) == 1; });
      EXPECT_EQ(answer, i + 2);
    }
  });
  for (int i = 0; i < 100; ++i) {
    const std::uint32_t message = spu.channels.read(SPU_RdInMbox);
    spu.channels.write(SPU_WrOutMbox, message + 1);
    spu.channels.write(SPU_WrOutMbox, message + 2);
  }
  host.join();
  EXPECT_GT(spu.channels.counters().mailbox_waits.value(), 0U);
}

TEST(Signal, overwrites_or_collects_bits_by_its_mode) {
  TestSpu overwrite;
  overwrite.channels.signal(0, 3);
  overwrite.channels.signal(0, 4);
  EXPECT_EQ(overwrite.channels.read(SPU_RdSigNotify1), 4U);
  TestSpu collect(DmaMode::eager, 1, WordOrder::same, SignalMode::logical_or);
  collect.channels.signal(1, 3);
  collect.channels.signal(1, 4);
  EXPECT_EQ(collect.channels.count(SPU_RdSigNotify1), 0U);
  EXPECT_EQ(collect.channels.count(SPU_RdSigNotify2), 1U);
  EXPECT_EQ(collect.channels.read(SPU_RdSigNotify2), 7U);
}

TEST(Signal, a_read_clears_and_the_next_one_blocks) {
  TestSpu spu(DmaMode::eager, 1, WordOrder::same, SignalMode::logical_or);
  spu.channels.signal(0, 3);
  EXPECT_EQ(spu.channels.read(SPU_RdSigNotify1), 3U);
  EXPECT_EQ(spu.channels.count(SPU_RdSigNotify1), 0U);
  std::thread host([&] {
    // The read says that it waits before it does.
    while (spu.channels.counters().signal_waits.value() == 0) std::this_thread::yield();
    spu.channels.signal(0, 8);
  });
  EXPECT_EQ(spu.channels.read(SPU_RdSigNotify1), 8U);
  host.join();
  EXPECT_EQ(spu.channels.counters().signal_waits.value(), 1U);
}

TEST(Signal, a_word_of_zero_is_a_signal_too) {
  TestSpu spu;
  spu.channels.signal(0, 0);
  EXPECT_EQ(spu.channels.count(SPU_RdSigNotify1), 1U);
  EXPECT_EQ(spu.channels.read(SPU_RdSigNotify1), 0U);
}

TEST(WaitPoint, gives_up_at_its_deadline) {
  WaitPoint point;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(3);
  EXPECT_FALSE(point.wait_until([] { return false; }, deadline));
  EXPECT_GE(std::chrono::steady_clock::now(), deadline);
}

TEST(WaitPoint, wakes_whoever_waits_at_the_point_behind_it) {
  WaitPoint behind;
  WaitPoint front(&behind);
  std::atomic<bool> state{false};
  std::thread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    state = true;
    front.notify();
  });
  behind.wait([&] { return state.load(); });
  writer.join();
  EXPECT_TRUE(state.load());
}

}  // namespace
}  // namespace spu_emu
