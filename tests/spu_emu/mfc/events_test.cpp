// Events and the decrementer.
#include <thread>

#include "test_spu.h"

namespace spu_emu {
namespace {

TEST(Decrementer, counts_down_at_the_timebase) {
  TestSpu spu;
  EXPECT_EQ(spu.channels.read(SPU_RdDec), 0U);
  spu.channels.write(SPU_WrDec, 1000);
  EXPECT_EQ(spu.channels.read(SPU_RdDec), 1000U);
  spu.timebase.now += 300;
  EXPECT_EQ(spu.channels.read(SPU_RdDec), 700U);
  spu.timebase.now += 701;
  EXPECT_EQ(spu.channels.read(SPU_RdDec), 0xffffffffU);
}

TEST(Decrementer, counts_real_time_at_its_frequency) {
  const SteadyTimebase timebase(79.8e6);
  const std::uint64_t before = timebase.ticks();
  const auto start = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const double ticks = static_cast<double>(timebase.ticks() - before);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  EXPECT_NEAR(ticks / (time.count() * 79.8e6), 1.0, 0.05);
  EXPECT_EQ(timebase.duration(79800).count(), 1000000);
}

TEST(Decrementer, raises_its_event_once_when_it_passes_zero) {
  TestSpu spu;
  spu.channels.write(SPU_WrEventMask, MFC_DECREMENTER_EVENT);
  spu.channels.write(SPU_WrDec, 100);
  spu.timebase.now += 100;
  EXPECT_EQ(spu.channels.count(SPU_RdEventStat), 0U);
  spu.timebase.now += 1;
  EXPECT_EQ(spu.channels.count(SPU_RdEventStat), 1U);
  EXPECT_EQ(spu.channels.read(SPU_RdEventStat), unsigned{MFC_DECREMENTER_EVENT});
  spu.channels.write(SPU_WrEventAck, MFC_DECREMENTER_EVENT);
  EXPECT_EQ(spu.channels.count(SPU_RdEventStat), 0U);
}

TEST(Decrementer, wakes_a_blocked_spu) {
  LocalBytes local;
  FlatLocalStore store(local.bytes.data(), kLocalStoreSize, WordOrder::same);
  const SteadyTimebase timebase(1e6);
  SpuChannels channels(store, timebase, {});
  channels.write(SPU_WrEventMask, MFC_DECREMENTER_EVENT);
  channels.write(SPU_WrDec, 5000);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(channels.read(SPU_RdEventStat), unsigned{MFC_DECREMENTER_EVENT});
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(4));
  EXPECT_EQ(channels.counters().event_waits.value(), 1U);
}

TEST(Events, the_mask_hides_but_does_not_forget) {
  TestSpu spu;
  spu.channels.signal(0, 1);
  EXPECT_EQ(spu.channels.count(SPU_RdEventStat), 0U);
  spu.channels.write(SPU_WrEventMask, MFC_SIGNAL_NOTIFY_1_EVENT | MFC_SIGNAL_NOTIFY_2_EVENT);
  EXPECT_EQ(spu.channels.read(SPU_RdEventMask),
            unsigned{MFC_SIGNAL_NOTIFY_1_EVENT | MFC_SIGNAL_NOTIFY_2_EVENT});
  EXPECT_EQ(spu.channels.read(SPU_RdEventStat), unsigned{MFC_SIGNAL_NOTIFY_1_EVENT});
  EXPECT_EQ(spu.channels.read(SPU_RdEventStat), unsigned{MFC_SIGNAL_NOTIFY_1_EVENT});
  spu.channels.write(SPU_WrEventAck, MFC_SIGNAL_NOTIFY_1_EVENT);
  EXPECT_EQ(spu.channels.count(SPU_RdEventStat), 0U);
}

TEST(Events, each_source_raises_its_own_bit) {
  const auto raised = [](DmaMode mode, auto&& cause) {
    TestSpu spu(mode);
    spu.channels.write(SPU_WrEventMask, 0xffffffffU);
    cause(spu);
    return spu.channels.read(SPU_RdEventStat);
  };
  std::uint32_t word = 5;
  EXPECT_EQ(raised(DmaMode::eager, [&](TestSpu& s) { s.channels.write_in_mailbox(&word, 1); }),
            unsigned{MFC_IN_MBOX_AVAILABLE_EVENT});
  EXPECT_EQ(raised(DmaMode::eager, [&](TestSpu& s) { s.channels.signal(1, 1); }),
            unsigned{MFC_SIGNAL_NOTIFY_2_EVENT});
  EXPECT_EQ(raised(DmaMode::eager,
                   [&](TestSpu& s) {
                     s.channels.write(SPU_WrOutMbox, 1);
                     s.channels.read_out_mailbox(&word, 1);
                   }),
            unsigned{MFC_OUT_MBOX_AVAILABLE_EVENT});
  EXPECT_EQ(raised(DmaMode::eager,
                   [&](TestSpu& s) {
                     s.channels.write(SPU_WrOutIntrMbox, 1);
                     s.channels.read_out_interrupt_mailbox(&word, 1);
                   }),
            unsigned{MFC_OUT_INTR_MBOX_AVAILABLE_EVENT});
  EXPECT_EQ(raised(DmaMode::eager, [&](TestSpu& s) { s.channels.write(MFC_WrMSSyncReq, 0); }),
            unsigned{MFC_MULTI_SRC_SYNC_EVENT});
}

TEST(Events, a_finished_tag_group_raises_its_event_in_every_mode) {
  for (const DmaMode mode : {DmaMode::eager, DmaMode::late, DmaMode::unchecked}) {
    TestSpu spu(mode);
    spu.channels.write(SPU_WrEventMask, MFC_TAG_STATUS_UPDATE_EVENT);
    spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 64, 4);
    spu.channels.write(MFC_WrTagMask, 1U << 4);
    spu.channels.write(MFC_WrTagUpdate, MFC_TAG_UPDATE_ALL);
    EXPECT_EQ(spu.channels.read(SPU_RdEventStat), unsigned{MFC_TAG_STATUS_UPDATE_EVENT});
    EXPECT_EQ(spu.channels.read(MFC_RdTagStat), 1U << 4);
    EXPECT_TRUE(spu.same(0x1000, 0, 64));
  }
}

TEST(Events, a_slot_in_a_full_queue_raises_its_event) {
  TestSpu spu(DmaMode::late);
  spu.channels.write(SPU_WrEventMask, MFC_COMMAND_QUEUE_AVAILABLE_EVENT);
  for (std::uint32_t i = 0; i < 16; ++i) spu.dma(MFC_GET_CMD, 0x1000 + i * 64, spu.ea(i * 64), 64, 0);
  EXPECT_EQ(spu.channels.read(SPU_RdEventStat), unsigned{MFC_COMMAND_QUEUE_AVAILABLE_EVENT});
  spu.channels.abandon();
}

}  // namespace
}  // namespace spu_emu
