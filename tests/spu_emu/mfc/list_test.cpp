// DMA lists: what they move, where their local store addresses go, and stall-and-notify.
#include "mfc/list.h"
#include "test_spu.h"

namespace spu_emu {
namespace {

constexpr std::uint32_t kList = 0x2000;
constexpr std::uint32_t kData = 0x4000;
constexpr std::uint32_t kNotify = 0x80000000U;

class EveryMode : public testing::TestWithParam<DmaMode> {
 protected:
  static std::uint64_t list_ea(const TestSpu& spu) {
    return (spu.ea() & ~std::uint64_t{0xffffffffU}) | kList;
  }
};
INSTANTIATE_TEST_SUITE_P(Modes, EveryMode, testing::Values(DmaMode::eager, DmaMode::late, DmaMode::unchecked),
                         mode_name);

TEST_P(EveryMode, a_list_gathers_its_elements_one_after_the_other) {
  TestSpu spu(GetParam());
  spu.write_element(kList, 0, 64, spu.ea_low(1024));
  spu.write_element(kList, 1, 16, spu.ea_low(0));
  spu.write_element(kList, 2, 4096, spu.ea_low(8192));
  spu.dma(MFC_GETL_CMD, kData, list_ea(spu), 3 * 8, 1);
  spu.wait(2);
  EXPECT_TRUE(spu.same(kData, 1024, 64));
  EXPECT_TRUE(spu.same(kData + 64, 0, 16));
  EXPECT_TRUE(spu.same(kData + 80, 8192, 4096));
  EXPECT_EQ(spu.channels.queue_counters().list_elements.value(), 3U);
}

TEST_P(EveryMode, a_list_scatters_too) {
  TestSpu spu(GetParam());
  for (std::uint32_t i = 0; i < 64; ++i) spu.local->bytes[kData + i] = static_cast<std::byte>(0x80U + i);
  spu.write_element(kList, 0, 32, spu.ea_low(1024));
  spu.write_element(kList, 1, 32, spu.ea_low(512));
  spu.dma(MFC_PUTL_CMD, kData, list_ea(spu), 2 * 8, 1);
  spu.wait(2);
  EXPECT_TRUE(spu.same(kData, 1024, 32));
  EXPECT_TRUE(spu.same(kData + 32, 512, 32));
}

TEST_P(EveryMode, the_local_store_address_rounds_up_to_16_between_elements) {
  TestSpu spu(GetParam());
  spu.write_element(kList, 0, 4, spu.ea_low(1024 + 8));
  spu.write_element(kList, 1, 2, spu.ea_low(512 + 6));
  spu.write_element(kList, 2, 16, spu.ea_low(0));
  spu.dma(MFC_GETL_CMD, kData, list_ea(spu), 3 * 8, 1);
  spu.wait(2);
  EXPECT_TRUE(spu.same(kData + 8, 1032, 4));
  EXPECT_TRUE(spu.same(kData + 16 + 6, 518, 2));
  EXPECT_TRUE(spu.same(kData + 32, 0, 16));
}

TEST_P(EveryMode, a_list_of_2048_elements_is_legal) {
  TestSpu spu(GetParam());
  for (std::uint32_t i = 0; i < 2048; ++i) spu.write_element(kList, i, 16, spu.ea_low((i * 48) % 32768));
  spu.dma(MFC_GETL_CMD, 0x8000, list_ea(spu), 2048 * 8, 1);
  spu.wait(2);
  for (std::uint32_t i = 0; i < 2048; ++i) ASSERT_TRUE(spu.same(0x8000 + i * 16, (i * 48) % 32768, 16)) << i;
}

TEST_P(EveryMode, a_list_stalls_after_a_marked_element_until_acknowledged) {
  TestSpu spu(GetParam());
  spu.write_element(kList, 0, 16 | kNotify, spu.ea_low(0));
  spu.write_element(kList, 1, 16, spu.ea_low(0));
  spu.dma(MFC_GETL_CMD, kData, list_ea(spu), 2 * 8, 6);
  EXPECT_EQ(spu.channels.count(MFC_RdListStallStat), 1U);
  EXPECT_EQ(spu.channels.read(MFC_RdListStallStat), 1U << 6);
  EXPECT_TRUE(spu.same(kData, 0, 16));
  EXPECT_EQ(spu.peek(kData + 16), std::byte{0});
  spu.write_element(kList, 1, 32, spu.ea_low(2048));
  spu.channels.write(MFC_WrListStallAck, 6);
  EXPECT_EQ(spu.wait(1U << 6), 1U << 6);
  EXPECT_TRUE(spu.same(kData + 16, 2048, 32));
}

TEST_P(EveryMode, a_list_that_stalls_at_its_end_is_done_when_acknowledged) {
  TestSpu spu(GetParam());
  spu.write_element(kList, 0, 16 | kNotify, spu.ea_low(0));
  spu.dma(MFC_GETL_CMD, kData, list_ea(spu), 8, 6);
  EXPECT_EQ(spu.channels.read(MFC_RdListStallStat), 1U << 6);
  EXPECT_EQ(spu.wait(1U << 6, MFC_TAG_UPDATE_IMMEDIATE), 0U);
  spu.channels.write(MFC_WrListStallAck, 6);
  EXPECT_EQ(spu.wait(1U << 6), 1U << 6);
}

TEST_P(EveryMode, a_fenced_command_waits_behind_a_stalled_list_and_others_do_not) {
  TestSpu spu(GetParam());
  spu.write_element(kList, 0, 16 | kNotify, spu.ea_low(0));
  spu.dma(MFC_GETL_CMD, kData, list_ea(spu), 8, 6);
  EXPECT_EQ(spu.channels.read(MFC_RdListStallStat), 1U << 6);
  spu.dma(MFC_GETF_CMD, 0x6000, spu.ea(1024), 32, 6);
  spu.dma(MFC_GET_CMD, 0x7000, spu.ea(2048), 32, 7);
  EXPECT_EQ(spu.wait(1U << 7), 1U << 7);
  EXPECT_TRUE(spu.same(0x7000, 2048, 32));
  EXPECT_NE(spu.peek(0x6000 + 5), spu.main->bytes[1024 + 5]);
  spu.channels.write(MFC_WrListStallAck, 6);
  EXPECT_EQ(spu.wait(1U << 6), 1U << 6);
  EXPECT_TRUE(spu.same(0x6000, 1024, 32));
}

TEST_P(EveryMode, waiting_for_a_stalled_tag_is_reported_as_endless) {
  TestSpu spu(GetParam());
  spu.write_element(kList, 0, 16 | kNotify, spu.ea_low(0));
  spu.dma(MFC_GETL_CMD, kData, list_ea(spu), 8, 6);
  expect_fault(Rule::deadlock, [&] { spu.wait(1U << 6); });
  spu.channels.write(MFC_WrTagMask, 1U << 6);
  spu.channels.write(MFC_WrTagUpdate, MFC_TAG_UPDATE_ANY);
  expect_fault(Rule::deadlock, [&] { spu.channels.read(MFC_RdTagStat); });
}

TEST_P(EveryMode, reading_the_stall_status_without_a_stalling_list_is_reported_as_endless) {
  TestSpu spu(GetParam());
  EXPECT_EQ(spu.channels.count(MFC_RdListStallStat), 0U);
  expect_fault(Rule::deadlock, [&] { spu.channels.read(MFC_RdListStallStat); });
}

TEST_P(EveryMode, acknowledging_a_tag_that_has_not_stalled_is_refused) {
  TestSpu spu(GetParam());
  expect_fault(Rule::list_acknowledge, [&] { spu.channels.write(MFC_WrListStallAck, 3); });
}

TEST_P(EveryMode, a_queue_full_of_commands_behind_a_stalled_list_is_reported_as_endless) {
  TestSpu spu(GetParam());
  spu.write_element(kList, 0, 16 | kNotify, spu.ea_low(0));
  spu.dma(MFC_GETL_CMD, kData, list_ea(spu), 8, 6);
  spu.channels.read(MFC_RdListStallStat);
  for (std::uint32_t i = 0; i < 15; ++i) spu.dma(MFC_GETF_CMD, 0x6000 + i * 16, spu.ea(), 16, 6);
  EXPECT_EQ(spu.channels.count(MFC_Cmd), 0U);
  expect_fault(Rule::deadlock, [&] { spu.dma(MFC_GETF_CMD, 0x7000, spu.ea(), 16, 6); });
}

TEST(List, changing_an_element_before_the_list_is_done_is_reported) {
  TestSpu spu(DmaMode::late);
  const std::uint64_t ea = (spu.ea() & ~std::uint64_t{0xffffffffU}) | kList;
  spu.write_element(kList, 0, 16, spu.ea_low(0));
  spu.write_element(kList, 1, 16, spu.ea_low(0));
  spu.dma(MFC_GETL_CMD, kData, ea, 16, 6);
  spu.write_element(kList, 1, 16, spu.ea_low(1024));
  const std::string text = expect_fault(Rule::in_flight_list, [&] { spu.wait(1U << 6); });
  EXPECT_NE(text.find("element 1"), std::string::npos) << text;
}

TEST(List, a_stall_raises_its_event) {
  TestSpu spu;
  spu.write_element(kList, 0, 16 | kNotify, spu.ea_low(0));
  spu.channels.write(SPU_WrEventMask, MFC_LIST_STALL_NOTIFY_EVENT);
  spu.dma(MFC_GETL_CMD, kData, (spu.ea() & ~std::uint64_t{0xffffffffU}) | kList, 8, 6);
  EXPECT_EQ(spu.channels.read(SPU_RdEventStat), unsigned{MFC_LIST_STALL_NOTIFY_EVENT});
}

TEST(List, elements_are_read_by_value_in_either_byte_order) {
  TestSpu spu(DmaMode::eager, 1, WordOrder::swapped);
  spu.write_element(kList, 0, __builtin_bswap32(16), __builtin_bswap32(spu.ea_low(64)));
  spu.dma(MFC_GETL_CMD, kData, (spu.ea() & ~std::uint64_t{0xffffffffU}) | kList, 8, 1);
  for (std::uint32_t i = 0; i < 16; ++i) EXPECT_EQ(spu.peek(kData + i), spu.main->bytes[64 + (i ^ 3U)]);
}

}  // namespace
}  // namespace spu_emu
