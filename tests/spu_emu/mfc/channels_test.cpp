// Channels that belong to no larger subject: tag mask and updates, machine state, and what no program may do.
#include "test_spu.h"

namespace spu_emu {
namespace {

TEST(Channels, the_tag_status_tells_the_done_tags_of_the_mask) {
  TestSpu spu;
  spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 64, 4);
  EXPECT_EQ(spu.wait(0x30), 0x30U);
  EXPECT_EQ(spu.channels.read(MFC_RdTagMask), 0x30U);
  EXPECT_EQ(spu.wait(0), 0U);
  EXPECT_EQ(spu.wait(0x10, MFC_TAG_UPDATE_ANY), 0x10U);
  EXPECT_EQ(spu.wait(0x10, MFC_TAG_UPDATE_IMMEDIATE), 0x10U);
}

TEST(Channels, the_tag_status_without_an_update_is_reported_as_endless) {
  TestSpu spu;
  EXPECT_EQ(spu.channels.count(MFC_RdTagStat), 0U);
  expect_fault(Rule::deadlock, [&] { spu.channels.read(MFC_RdTagStat); });
  spu.wait(1);
  expect_fault(Rule::deadlock, [&] { spu.channels.read(MFC_RdTagStat); });
}

TEST(Channels, a_tag_update_of_unknown_kind_is_refused) {
  TestSpu spu;
  expect_fault(Rule::tag_update, [&] { spu.channels.write(MFC_WrTagUpdate, 3); });
}

TEST(Channels, unknown_channels_and_wrong_directions_are_refused) {
  TestSpu spu;
  for (const std::uint32_t channel : {5U, 6U, 10U, 31U, 32U, 127U}) {
    expect_fault(Rule::channel, [&] { spu.channels.read(channel); });
    expect_fault(Rule::channel, [&] { spu.channels.write(channel, 0); });
  }
  for (const std::uint32_t channel : {SPU_WrEventMask, SPU_WrDec, MFC_LSA, MFC_Cmd, SPU_WrOutMbox}) {
    expect_fault(Rule::channel, [&] { spu.channels.read(channel, {"here.cpp", 3}); });
  }
  for (const std::uint32_t channel : {SPU_RdEventStat, SPU_RdDec, MFC_RdTagStat, SPU_RdInMbox}) {
    expect_fault(Rule::channel, [&] { spu.channels.write(channel, 0, {"here.cpp", 3}); });
  }
}

TEST(Channels, srr0_keeps_its_value_and_the_machine_status_is_plain) {
  TestSpu spu;
  spu.channels.write(SPU_WrSRR0, 0x1234);
  EXPECT_EQ(spu.channels.read(SPU_RdSRR0), 0x1234U);
  EXPECT_EQ(spu.channels.read(SPU_RdMachStat), 0U);
}

TEST(Channels, an_empty_queue_has_sixteen_slots) {
  TestSpu spu;
  EXPECT_EQ(spu.channels.count(MFC_Cmd), 16U);
  EXPECT_EQ(spu.channels.count(MFC_WrTagUpdate), 1U);
  EXPECT_EQ(spu.channels.count(MFC_WrMSSyncReq), 1U);
}

TEST(Channels, counts_what_they_do) {
  TestSpu spu;
  spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 64, 4);
  spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(), 32, 4);
  spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(), 16, 4);
  spu.wait(1U << 4);
  const QueueCounters& counters = spu.channels.queue_counters();
  EXPECT_EQ(counters.gets.value(), 1U);
  EXPECT_EQ(counters.puts.value(), 2U);
  EXPECT_EQ(counters.bytes_in.value(), 64U);
  EXPECT_EQ(counters.bytes_out.value(), 48U);
  EXPECT_EQ(spu.channels.counters().tag_waits.value(), 1U);
}

TEST(TagTable, gives_every_tag_once) {
  TagTable tags;
  for (std::uint32_t i = 0; i < 32; ++i) EXPECT_EQ(tags.reserve(1), i);
  EXPECT_EQ(tags.reserve(1), TagTable::kInvalid);
  EXPECT_EQ(tags.release(17, 1), TagTable::kValid);
  EXPECT_EQ(tags.reserve(1), 17U);
}

TEST(TagTable, reserves_neighbouring_tags_together) {
  TagTable tags;
  EXPECT_EQ(tags.reserve(30), 0U);
  EXPECT_EQ(tags.reserve(3), TagTable::kInvalid);
  EXPECT_EQ(tags.reserve(2), 30U);
  EXPECT_EQ(tags.release(4, 3), TagTable::kValid);
  EXPECT_EQ(tags.reserve(4), TagTable::kInvalid);
  EXPECT_EQ(tags.reserve(3), 4U);
}

TEST(TagTable, refuses_counts_and_tags_out_of_range_and_tags_not_reserved) {
  TagTable tags;
  EXPECT_EQ(tags.reserve(0), TagTable::kInvalid);
  EXPECT_EQ(tags.reserve(33), TagTable::kInvalid);
  EXPECT_EQ(tags.release(3, 1), TagTable::kInvalid);
  EXPECT_EQ(tags.release(31, 2), TagTable::kInvalid);
  EXPECT_EQ(tags.release(0xffffffffU, 1), TagTable::kInvalid);
  EXPECT_EQ(tags.reserve(32), 0U);
  EXPECT_EQ(tags.release(0, 32), TagTable::kValid);
}

}  // namespace
}  // namespace spu_emu
