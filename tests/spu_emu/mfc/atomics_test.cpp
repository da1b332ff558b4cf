// Lock-line reservations: the atomic commands, what loses a reservation, and many SPEs on one line.
#include <thread>
#include <vector>

#include "test_spu.h"

namespace spu_emu {
namespace {

std::uint32_t atomic(TestSpu& spu, std::uint32_t opcode, std::uint32_t ls, std::uint64_t ea) {
  spu.dma(opcode, ls, ea, 128, 0);
  return spu.channels.read(MFC_RdAtomicStat);
}

TEST(Atomics, getllar_and_putllc_move_a_line_and_tell_their_status) {
  TestSpu spu;
  EXPECT_EQ(atomic(spu, MFC_GETLLAR_CMD, 0x1000, spu.ea(256)), unsigned{MFC_GETLLAR_STATUS});
  EXPECT_TRUE(spu.same(0x1000, 256, 128));
  spu.local->bytes[0x1005] = std::byte{0xee};
  EXPECT_EQ(atomic(spu, MFC_PUTLLC_CMD, 0x1000, spu.ea(256)), 0U);
  EXPECT_TRUE(spu.same(0x1000, 256, 128));
}

TEST(Atomics, the_low_seven_address_bits_are_ignored) {
  TestSpu spu;
  atomic(spu, MFC_GETLLAR_CMD, 0x1033, spu.ea(256 + 77));
  EXPECT_TRUE(spu.same(0x1000, 256, 128));
}

TEST(Atomics, putllc_without_a_reservation_fails_and_stores_nothing) {
  TestSpu spu;
  const auto before = spu.main->bytes;
  spu.local->bytes[0x1000] = std::byte{0xee};
  EXPECT_EQ(atomic(spu, MFC_PUTLLC_CMD, 0x1000, spu.ea()), unsigned{MFC_PUTLLC_STATUS});
  EXPECT_EQ(spu.main->bytes, before);
  EXPECT_EQ(spu.channels.counters().lost_reservations.value(), 1U);
}

TEST(Atomics, putllc_to_another_line_fails_and_ends_the_reservation) {
  TestSpu spu;
  atomic(spu, MFC_GETLLAR_CMD, 0x1000, spu.ea());
  EXPECT_EQ(atomic(spu, MFC_PUTLLC_CMD, 0x1000, spu.ea(128)), unsigned{MFC_PUTLLC_STATUS});
  EXPECT_EQ(atomic(spu, MFC_PUTLLC_CMD, 0x1000, spu.ea()), unsigned{MFC_PUTLLC_STATUS});
}

TEST(Atomics, a_second_getllar_moves_the_reservation) {
  TestSpu spu;
  atomic(spu, MFC_GETLLAR_CMD, 0x1000, spu.ea());
  atomic(spu, MFC_GETLLAR_CMD, 0x1000, spu.ea(128));
  EXPECT_EQ(atomic(spu, MFC_PUTLLC_CMD, 0x1000, spu.ea(128)), 0U);
}

TEST(Atomics, any_other_store_to_the_line_loses_the_reservation) {
  const auto loses = [](auto&& store) {
    TestSpu spu;
    TestSpu other;
    atomic(spu, MFC_GETLLAR_CMD, 0x1000, spu.ea());
    store(spu, other);
    return atomic(spu, MFC_PUTLLC_CMD, 0x1000, spu.ea()) == unsigned{MFC_PUTLLC_STATUS};
  };
  EXPECT_TRUE(loses([](TestSpu& spu, TestSpu&) { atomic(spu, MFC_PUTLLUC_CMD, 0x1000, spu.ea()); }));
  EXPECT_TRUE(loses([](TestSpu& spu, TestSpu&) { spu.dma(MFC_PUTQLLUC_CMD, 0x1000, spu.ea(), 128, 1); }));
  EXPECT_TRUE(loses([](TestSpu& spu, TestSpu&) { spu.dma(MFC_PUT_CMD, 0x1010, spu.ea(16), 16, 1); }));
  EXPECT_TRUE(loses([](TestSpu& spu, TestSpu& other) { other.dma(MFC_PUT_CMD, 0x10, spu.ea(112), 16, 1); }));
  EXPECT_TRUE(loses([](TestSpu& spu, TestSpu& other) { other.dma(MFC_SDCRZ_CMD, 0, spu.ea(), 128, 1); }));
  EXPECT_TRUE(loses([](TestSpu& spu, TestSpu& other) {
    atomic(other, MFC_GETLLAR_CMD, 0x1000, spu.ea());
    atomic(other, MFC_PUTLLC_CMD, 0x1000, spu.ea());
  }));
  EXPECT_TRUE(loses([](TestSpu& spu, TestSpu&) { spu.main->bytes[100] = std::byte{0xfe}; }));
  EXPECT_FALSE(
      loses([](TestSpu& spu, TestSpu& other) { other.dma(MFC_PUT_CMD, 0x10, spu.ea(128), 128, 1); }));
  EXPECT_FALSE(loses([](TestSpu& spu, TestSpu& other) { atomic(other, MFC_GETLLAR_CMD, 0x1000, spu.ea()); }));
}

TEST(Atomics, putlluc_stores_and_tells_its_status) {
  TestSpu spu;
  spu.local->bytes[0x1001] = std::byte{0xab};
  EXPECT_EQ(atomic(spu, MFC_PUTLLUC_CMD, 0x1000, spu.ea()), unsigned{MFC_PUTLLUC_STATUS});
  EXPECT_TRUE(spu.same(0x1000, 0, 128));
}

TEST(Atomics, putqlluc_is_queued_and_done_with_its_tag) {
  TestSpu spu(DmaMode::late);
  spu.local->bytes[0x1001] = std::byte{0xab};
  spu.dma(MFC_PUTQLLUC_CMD, 0x1000, spu.ea(), 128, 3);
  EXPECT_FALSE(spu.same(0x1000, 0, 128));
  EXPECT_EQ(spu.wait(8), 8U);
  EXPECT_TRUE(spu.same(0x1000, 0, 128));
  EXPECT_EQ(spu.channels.count(MFC_RdAtomicStat), 0U);
}

TEST(Atomics, sdcrz_zeroes_whole_lines) {
  TestSpu spu;
  spu.dma(MFC_SDCRZ_CMD, 0, spu.ea(128 + 5), 130, 3);
  EXPECT_EQ(spu.main->bytes[127], TestSpu::pattern(127));
  for (std::size_t i = 128; i < 384; ++i) ASSERT_EQ(spu.main->bytes[i], std::byte{0}) << i;
  EXPECT_EQ(spu.main->bytes[385], TestSpu::pattern(385));
}

TEST(Atomics, a_lost_reservation_raises_its_event) {
  TestSpu spu;
  TestSpu other;
  spu.channels.write(SPU_WrEventMask, MFC_LLR_LOST_EVENT);
  atomic(spu, MFC_GETLLAR_CMD, 0x1000, spu.ea());
  EXPECT_EQ(spu.channels.count(SPU_RdEventStat), 0U);
  other.dma(MFC_PUT_CMD, 0x1000, spu.ea(), 128, 0);
  EXPECT_EQ(spu.channels.read(SPU_RdEventStat), unsigned{MFC_LLR_LOST_EVENT});
}

TEST(Atomics, a_blocked_spu_notices_that_another_thread_changed_its_line) {
  TestSpu spu;
  auto* word = reinterpret_cast<std::uint32_t*>(spu.main->bytes.data());
  spu.channels.write(SPU_WrEventMask, MFC_LLR_LOST_EVENT);
  atomic(spu, MFC_GETLLAR_CMD, 0x1000, spu.ea());
  std::thread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::atomic_ref(*word).store(0x12345678);
  });
  EXPECT_EQ(spu.channels.read(SPU_RdEventStat), unsigned{MFC_LLR_LOST_EVENT});
  writer.join();
}

TEST(Atomics, the_atomic_status_is_read_once_and_not_without_a_command) {
  TestSpu spu;
  EXPECT_EQ(spu.channels.count(MFC_RdAtomicStat), 0U);
  expect_fault(Rule::deadlock, [&] { spu.channels.read(MFC_RdAtomicStat); });
  spu.dma(MFC_GETLLAR_CMD, 0x1000, spu.ea(), 128, 0);
  EXPECT_EQ(spu.channels.count(MFC_RdAtomicStat), 1U);
  spu.channels.read(MFC_RdAtomicStat);
  EXPECT_EQ(spu.channels.count(MFC_RdAtomicStat), 0U);
}

void count_up(TestSpu& spu, std::uint64_t ea, int times, WordOrder order) {
  auto* word = reinterpret_cast<std::uint32_t*>(spu.local->bytes.data() + 0x1000);
  for (int i = 0; i < times; ++i) {
    do {
      atomic(spu, MFC_GETLLAR_CMD, 0x1000, ea);
      const std::uint32_t value = order == WordOrder::swapped ? __builtin_bswap32(*word) : *word;
      *word = order == WordOrder::swapped ? __builtin_bswap32(value + 1) : value + 1;
    } while (atomic(spu, MFC_PUTLLC_CMD, 0x1000, ea) == unsigned{MFC_PUTLLC_STATUS});
  }
}

TEST(Atomics, eight_spes_and_a_host_thread_count_together_in_one_line) {
  struct alignas(128) Line {
    std::uint32_t words[32] = {};
  };
  constexpr int kTimes = 500;
  Line line;
  std::vector<std::unique_ptr<TestSpu>> spus;
  for (int i = 0; i < 8; ++i) {
    const WordOrder order = i % 2 == 0 ? WordOrder::same : WordOrder::swapped;
    spus.push_back(std::make_unique<TestSpu>(DmaMode::eager, 1, order));
  }
  std::vector<std::thread> threads;
  for (auto& spu : spus) {
    threads.emplace_back([&line, &spu] {
      count_up(*spu, reinterpret_cast<std::uintptr_t>(&line), kTimes, spu->store.word_order());
    });
  }
  for (int i = 0; i < kTimes; ++i) std::atomic_ref(line.words[0]).fetch_add(1);
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(line.words[0], 9U * kTimes);
}

}  // namespace
}  // namespace spu_emu
