// Late mode: when bytes move, what stands in their place until then, and what a program must not do
// meanwhile.
#include "mfc/watch.h"
#include "test_spu.h"

#ifdef SPU_EMU_TEST_ASAN
#include <sanitizer/asan_interface.h>
#endif

namespace spu_emu {
namespace {

constexpr std::uint32_t kTag = 1U << 4;

TEST(LateMode, a_get_lands_at_the_wait_that_covers_it) {
  TestSpu spu(DmaMode::late);
  spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 256, 4);
  for (std::uint32_t i = 0; i < 256; ++i) ASSERT_EQ(spu.peek(0x1000 + i), kPoison);
  spu.wait(1U << 5);
  ASSERT_EQ(spu.peek(0x1000), kPoison);
  EXPECT_EQ(spu.wait(kTag), kTag);
  EXPECT_TRUE(spu.same(0x1000, 0, 256));
}

TEST(LateMode, a_get_reads_its_source_only_when_it_lands) {
  TestSpu spu(DmaMode::late);
  spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 16, 4);
  spu.main->bytes[3] = std::byte{0x77};
  spu.wait(kTag);
  EXPECT_EQ(spu.peek(0x1003), std::byte{0x77});
}

TEST(LateMode, a_program_that_does_not_wait_reads_poison) {
  TestSpu spu(DmaMode::late);
  spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 16, 4);
#ifdef SPU_EMU_TEST_ASAN
  EXPECT_TRUE(__asan_address_is_poisoned(spu.local->bytes.data() + 0x1000));
  EXPECT_TRUE(__asan_address_is_poisoned(spu.local->bytes.data() + 0x100f));
  EXPECT_FALSE(__asan_address_is_poisoned(spu.local->bytes.data() + 0x1010));
  EXPECT_DEATH(
      {
        volatile std::byte early = spu.local->bytes.data()[0x1000];
        static_cast<void>(early);
      },
      "use-after-poison");
#endif
  EXPECT_NE(spu.peek(0x1000), spu.main->bytes[0]);
  EXPECT_EQ(spu.peek(0x1000), kPoison);
}

TEST(LateMode, a_put_keeps_the_old_bytes_until_its_wait) {
  TestSpu spu(DmaMode::late);
  spu.local->bytes[0x1000] = std::byte{0x99};
  const std::byte before = spu.main->bytes[0];
  spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(), 16, 4);
  EXPECT_EQ(spu.main->bytes[0], before);
  spu.wait(kTag);
  EXPECT_EQ(spu.main->bytes[0], std::byte{0x99});
}

TEST(LateMode, a_put_lands_before_any_blocking_channel_access) {
  const auto lands_before = [](auto&& access) {
    TestSpu spu(DmaMode::late);
    spu.local->bytes[0x1000] = std::byte{0x99};
    spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(), 16, 4);
    access(spu.channels);
    return spu.main->bytes[0] == std::byte{0x99};
  };
  EXPECT_TRUE(lands_before([](SpuChannels& c) { c.write(SPU_WrOutMbox, 1); }));
  EXPECT_TRUE(lands_before([](SpuChannels& c) { c.write(SPU_WrOutIntrMbox, 1); }));
  EXPECT_TRUE(lands_before([](SpuChannels& c) {
    const std::uint32_t message = 1;
    c.write_in_mailbox(&message, 1);
    c.read(SPU_RdInMbox);
  }));
  EXPECT_TRUE(lands_before([](SpuChannels& c) {
    c.signal(0, 1);
    c.read(SPU_RdSigNotify1);
  }));
  EXPECT_TRUE(lands_before([](SpuChannels& c) {
    c.write(MFC_WrTagMask, 0);
    c.write(MFC_WrTagUpdate, MFC_TAG_UPDATE_ALL);
    c.read(MFC_RdTagStat);
  }));
  EXPECT_TRUE(lands_before([](SpuChannels& c) {
    c.write(SPU_WrEventMask, MFC_SIGNAL_NOTIFY_1_EVENT);
    c.signal(0, 1);
    c.read(SPU_RdEventStat);
  }));
  EXPECT_FALSE(lands_before([](SpuChannels& c) { c.count(SPU_RdInMbox); }));
}

TEST(LateMode, everything_lands_when_the_program_stops) {
  TestSpu spu(DmaMode::late);
  spu.local->bytes[0x1000] = std::byte{0x99};
  spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(), 16, 4);
  spu.dma(MFC_GET_CMD, 0x2000, spu.ea(1024), 32, 5);
  spu.channels.finish();
  EXPECT_EQ(spu.main->bytes[0], std::byte{0x99});
  EXPECT_TRUE(spu.same(0x2000, 1024, 32));
}

TEST(LateMode, writing_into_a_get_in_flight_is_reported_when_it_lands) {
  TestSpu spu(DmaMode::late);
  spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 64, 4);
  spu.poke(0x1020, std::byte{1});
  const std::string text = expect_fault(Rule::in_flight_write, [&] { spu.wait(kTag); });
  EXPECT_NE(text.find("program.cpp:42"), std::string::npos) << text;
}

TEST(LateMode, writing_into_a_put_in_flight_is_reported_when_it_lands) {
  TestSpu spu(DmaMode::late);
  spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(), 64, 4);
  spu.poke(0x103f, std::byte{1});
  expect_fault(Rule::in_flight_source, [&] { spu.wait(kTag); });
}

TEST(LateMode, unordered_commands_on_one_buffer_are_refused) {
  const auto conflict = [](std::uint32_t first, std::uint32_t second, std::uint32_t second_tag) {
    TestSpu spu(DmaMode::late);
    spu.dma(first, 0x1000, spu.ea(), 64, 4);
    expect_fault(Rule::in_flight_overlap, [&] { spu.dma(second, 0x1030, spu.ea(4096), 64, second_tag); });
  };
  conflict(MFC_GET_CMD, MFC_GET_CMD, 4);
  conflict(MFC_GET_CMD, MFC_PUT_CMD, 4);
  conflict(MFC_PUT_CMD, MFC_GET_CMD, 4);
  conflict(MFC_PUT_CMD, MFC_GETF_CMD, 5);
}

TEST(LateMode, a_fenced_get_may_refill_the_buffer_of_a_put) {
  for (const std::uint32_t opcode : {MFC_GETF_CMD, MFC_GETB_CMD}) {
    TestSpu spu(DmaMode::late);
    spu.local->bytes[0x1000] = std::byte{0x99};
    spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(), 64, 4);
    spu.dma(opcode, 0x1000, spu.ea(4096), 64, 4);
    spu.wait(kTag);
    EXPECT_EQ(spu.main->bytes[0], std::byte{0x99});
    EXPECT_TRUE(spu.same(0x1000, 4096, 64));
  }
}

TEST(LateMode, two_puts_may_share_a_source) {
  TestSpu spu(DmaMode::late);
  spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(), 64, 4);
  spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(4096), 64, 5);
  spu.wait(kTag | (1U << 5));
  EXPECT_TRUE(spu.same(0x1000, 0, 64));
  EXPECT_TRUE(spu.same(0x1000, 4096, 64));
}

TEST(LateMode, the_seventeenth_command_stalls_until_one_has_landed) {
  TestSpu spu(DmaMode::late);
  for (std::uint32_t i = 0; i < 16; ++i) {
    EXPECT_EQ(spu.channels.count(MFC_Cmd), 16 - i);
    spu.dma(MFC_GET_CMD, 0x1000 + i * 64, spu.ea(i * 64), 64, i);
  }
  EXPECT_EQ(spu.channels.queue_counters().queue_stalls.value(), 0U);
  spu.dma(MFC_GET_CMD, 0x8000, spu.ea(2048), 64, 16);
  EXPECT_EQ(spu.channels.queue_counters().queue_stalls.value(), 1U);
  EXPECT_EQ(spu.channels.queue_counters().gets.value(), 1U);
  spu.wait(0xffffffffU);
  EXPECT_TRUE(spu.same(0x1000, 0, 1024));
  EXPECT_TRUE(spu.same(0x8000, 2048, 64));
}

TEST(LateMode, the_proxy_queue_stalls_at_the_ninth_command) {
  TestSpu spu;
  CommandQueue proxy(spu.store, {Issuer::proxy, DmaMode::late, 1, nullptr, nullptr});
  for (std::uint32_t i = 0; i < 9; ++i) {
    proxy.issue({MFC_GET_CMD, i, 64, 0x1000 + i * 64, spu.ea(i * 64), {}});
  }
  EXPECT_EQ(proxy.counters().queue_stalls.value(), 1U);
  proxy.land_all();
  EXPECT_TRUE(spu.same(0x1000, 0, 9 * 64));
}

TEST(LateMode, a_poll_for_a_free_slot_lets_a_full_queue_go_on) {
  TestSpu spu(DmaMode::late);
  for (std::uint32_t i = 0; i < 16; ++i) spu.dma(MFC_GET_CMD, 0x1000 + i * 64, spu.ea(i * 64), 64, 0);
  EXPECT_EQ(spu.channels.count(MFC_Cmd), 1U);
  spu.channels.abandon();
}

TEST(LateMode, waiting_for_any_tag_ends_when_one_is_done) {
  bool partial = false;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    TestSpu spu(DmaMode::late, seed);
    spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 64, 4);
    spu.dma(MFC_GET_CMD, 0x2000, spu.ea(64), 64, 5);
    const std::uint32_t done = spu.wait(0x30, MFC_TAG_UPDATE_ANY);
    EXPECT_NE(done, 0U);
    EXPECT_EQ(done & ~0x30U, 0U);
    EXPECT_EQ((done & 0x10U) != 0, spu.peek(0x1000) == spu.main->bytes[0]);
    partial = partial || done != 0x30U;
    spu.channels.abandon();
  }
  EXPECT_TRUE(partial);
}

TEST(LateMode, asking_at_once_may_find_a_tag_undone_but_polling_ends) {
  bool undone = false;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    TestSpu spu(DmaMode::late, seed);
    spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 64, 4);
    int polls = 0;
    while (spu.wait(kTag, MFC_TAG_UPDATE_IMMEDIATE) != kTag) {
      undone = true;
      ASSERT_LT(++polls, 1000);
    }
    EXPECT_TRUE(spu.same(0x1000, 0, 64));
  }
  EXPECT_TRUE(undone);
}

TEST(LateMode, polling_the_count_of_the_tag_status_ends) {
  TestSpu spu(DmaMode::late);
  for (std::uint32_t i = 0; i < 4; ++i) spu.dma(MFC_GET_CMD, 0x1000 + i * 64, spu.ea(i * 64), 64, 4);
  spu.channels.write(MFC_WrTagMask, kTag);
  spu.channels.write(MFC_WrTagUpdate, MFC_TAG_UPDATE_ALL);
  EXPECT_EQ(spu.channels.count(MFC_RdTagStat), 0U);
  int polls = 0;
  while (spu.channels.count(MFC_RdTagStat) == 0) ASSERT_LT(++polls, 100);
  EXPECT_EQ(spu.channels.read(MFC_RdTagStat), kTag);
  EXPECT_TRUE(spu.same(0x1000, 0, 256));
}

TEST(LateMode, an_abandoned_queue_moves_nothing_and_frees_its_buffers) {
  TestSpu spu(DmaMode::late);
  spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 64, 4);
  spu.channels.abandon();
  spu.local->bytes[0x1000] = std::byte{5};
  EXPECT_EQ(spu.channels.count(MFC_Cmd), 16U);
  EXPECT_EQ(spu.wait(kTag), kTag);
  EXPECT_EQ(spu.peek(0x1000), std::byte{5});
}

}  // namespace
}  // namespace spu_emu
