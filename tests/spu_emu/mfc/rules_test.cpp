// Every rule for one command: what is legal passes, what is not is a fault that says so.
#include <libspe2-types.h>
#include <sys/mman.h>

#include "mfc/command_queue.h"
#include "test_spu.h"

namespace spu_emu {
namespace {

class EveryCheckedMode : public testing::TestWithParam<DmaMode> {};
INSTANTIATE_TEST_SUITE_P(Modes, EveryCheckedMode, testing::Values(DmaMode::eager, DmaMode::late), mode_name);

TEST_P(EveryCheckedMode, moves_every_legal_size_both_ways) {
  TestSpu spu(GetParam());
  for (const std::uint32_t size : {1U, 2U, 4U, 8U, 16U, 32U, 48U, 128U, 144U, 4096U, 16384U}) {
    spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), size, 3);
    spu.wait(1U << 3);
    EXPECT_TRUE(spu.same(0x1000, 0, size)) << size;
    spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(32768), size, 3);
    spu.wait(1U << 3);
    EXPECT_TRUE(spu.same(0x1000, 32768, size)) << size;
  }
}

TEST_P(EveryCheckedMode, moves_nothing_for_size_zero) {
  TestSpu spu(GetParam());
  spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 0, 3);
  spu.wait(1U << 3);
  EXPECT_EQ(spu.peek(0x1000), std::byte{0});
}

TEST_P(EveryCheckedMode, refuses_every_illegal_size) {
  TestSpu spu(GetParam());
  for (std::uint32_t size = 1; size <= 16400; ++size) {
    const bool legal = size == 1 || size == 2 || size == 4 || size == 8 || (size % 16 == 0 && size <= 16384);
    if (legal) continue;
    expect_fault(Rule::transfer_size, [&] { spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), size, 0); });
    expect_fault(Rule::transfer_size, [&] { spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(), size, 0); });
  }
  expect_fault(Rule::transfer_size, [&] { spu.dma(MFC_GET_CMD, 0, spu.ea(), 65536, 0); });
}

TEST_P(EveryCheckedMode, refuses_small_transfers_off_their_natural_alignment) {
  TestSpu spu(GetParam());
  for (const std::uint32_t size : {2U, 4U, 8U}) {
    for (std::uint32_t offset = 1; offset < 16; ++offset) {
      if (offset % size == 0) continue;
      expect_fault(Rule::natural_alignment,
                   [&] { spu.dma(MFC_GET_CMD, 0x1000 + offset, spu.ea(offset), size, 0); });
    }
  }
}

TEST_P(EveryCheckedMode, refuses_small_transfers_at_different_quadword_offsets) {
  TestSpu spu(GetParam());
  for (const std::uint32_t size : {1U, 2U, 4U, 8U}) {
    expect_fault(Rule::quadword_offset, [&] { spu.dma(MFC_GET_CMD, 0x1000, spu.ea(size), size, 0); });
    expect_fault(Rule::quadword_offset, [&] { spu.dma(MFC_PUT_CMD, 0x1000 + size, spu.ea(), size, 0); });
  }
}

TEST_P(EveryCheckedMode, refuses_large_transfers_that_are_not_16_aligned) {
  TestSpu spu(GetParam());
  for (std::uint32_t offset = 1; offset < 16; ++offset) {
    expect_fault(Rule::quadword_alignment,
                 [&] { spu.dma(MFC_GET_CMD, 0x1000 + offset, spu.ea(offset), 32, 0); });
    expect_fault(Rule::quadword_alignment, [&] { spu.dma(MFC_GET_CMD, 0x1000, spu.ea(offset), 16, 0); });
    expect_fault(Rule::quadword_alignment, [&] { spu.dma(MFC_PUT_CMD, 0x1000 + offset, spu.ea(), 16, 0); });
  }
}

TEST_P(EveryCheckedMode, refuses_tags_above_31) {
  TestSpu spu(GetParam());
  spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 16, 31);
  for (const std::uint32_t tag : {32U, 33U, 255U, 0xffffffffU}) {
    expect_fault(Rule::tag, [&] { spu.dma(MFC_GET_CMD, 0x2000, spu.ea(), 16, tag); });
  }
  spu.channels.abandon();
}

TEST_P(EveryCheckedMode, refuses_unknown_command_codes) {
  TestSpu spu(GetParam());
  for (const std::uint32_t opcode :
       {0x00U, 0x01U, 0x23U, 0x27U, 0x43U, 0x47U, 0x99U, 0xa3U, 0xb1U, 0xd4U, 0xffU}) {
    expect_fault(Rule::opcode, [&] { spu.dma(opcode, 0x1000, spu.ea(), 16, 0); });
  }
}

TEST_P(EveryCheckedMode, refuses_transfers_beyond_the_local_store) {
  TestSpu spu(GetParam());
  spu.dma(MFC_GET_CMD, kLocalStoreSize - 16, spu.ea(), 16, 0);
  spu.wait(1);
  expect_fault(Rule::local_store_range, [&] { spu.dma(MFC_GET_CMD, kLocalStoreSize - 16, spu.ea(), 32, 0); });
  expect_fault(Rule::local_store_range, [&] { spu.dma(MFC_PUT_CMD, kLocalStoreSize, spu.ea(), 16, 0); });
  expect_fault(Rule::local_store_range, [&] { spu.dma(MFC_GET_CMD, 0xfffffff0U, spu.ea(), 16, 0); });
}

TEST_P(EveryCheckedMode, refuses_addresses_that_no_program_owns) {
  TestSpu spu(GetParam());
  for (const std::uint64_t ea : {std::uint64_t{0}, std::uint64_t{0xfff0}, std::uint64_t{1} << 47U,
                                 std::uint64_t{0xffff800000000000U}, std::uint64_t{0xfffffffffffffff0U}}) {
    expect_fault(Rule::effective_address, [&] { spu.dma(MFC_GET_CMD, 0x1000, ea, 16, 0); });
    expect_fault(Rule::effective_address, [&] { spu.dma(MFC_GETLLAR_CMD, 0x1000, ea, 128, 0); });
  }
}

/// A page before one that is gone, and behind that another: what is mapped later rarely fits into the gap.
std::byte* page_before_a_gap() {
  auto* pages = static_cast<std::byte*>(
      mmap(nullptr, 3 * 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  munmap(pages + 4096, 4096);
  return pages;
}

/// Far from what the system maps, and no part of a sanitizer's shadow.
std::uint64_t unmapped_page() {
  return std::uint64_t{1} << 46U;
}

TEST_P(EveryCheckedMode, refuses_addresses_that_are_not_mapped) {
  TestSpu spu(GetParam());
  const std::uint64_t ea = unmapped_page();
  expect_fault(Rule::effective_address, [&] { spu.dma(MFC_GET_CMD, 0x1000, ea, 16, 0); });
  expect_fault(Rule::effective_address, [&] { spu.dma(MFC_PUT_CMD, 0x1000, ea, 16, 0); });
  expect_fault(Rule::effective_address, [&] { spu.dma(MFC_GETLLAR_CMD, 0x1000, ea, 128, 0); });
  expect_fault(Rule::effective_address, [&] { spu.dma(MFC_PUTLLUC_CMD, 0x1000, ea, 128, 0); });
  expect_fault(Rule::effective_address, [&] { spu.dma(MFC_SDCRZ_CMD, 0, ea, 128, 0); });
  const auto end = reinterpret_cast<std::uintptr_t>(page_before_a_gap()) + 4096;
  spu.dma(MFC_PUT_CMD, 0x1000, end - 32, 32, 0);
  expect_fault(Rule::effective_address, [&] { spu.dma(MFC_PUT_CMD, 0x1000, end - 32, 48, 0); });
}

std::string sentence_of(TestSpu& spu, std::uint64_t ea) {
  try {
    spu.dma(MFC_GET_CMD, 0x1000, ea, 16, 0);
  } catch (const Fault& fault) {
    return fault.text();
  }
  return "no fault";
}

TEST_P(EveryCheckedMode, says_where_an_address_of_exchanged_words_or_of_half_its_bits_leads) {
  TestSpu spu(GetParam());
  const std::uint64_t exchanged = spu.ea() << 32U | spu.ea() >> 32U;
  const std::string of_exchanged = sentence_of(spu, exchanged);
  EXPECT_NE(of_exchanged.find("its two words exchanged"), std::string::npos) << of_exchanged;
  const std::string of_half = sentence_of(spu, 0x7fff0000U);
  EXPECT_NE(of_half.find("it has 32 bits"), std::string::npos) << of_half;
  const std::string of_other = sentence_of(spu, unmapped_page());
  EXPECT_EQ(of_other.find(';'), std::string::npos) << of_other;
}

TEST_P(EveryCheckedMode, refuses_signals_of_other_sizes_than_4) {
  TestSpu spu(GetParam());
  expect_fault(Rule::transfer_size, [&] { spu.dma(MFC_SNDSIG_CMD, 0x1000, spu.ea(), 8, 0); });
}

TEST_P(EveryCheckedMode, refuses_to_zero_more_than_one_transfer_or_memory_that_no_program_owns) {
  TestSpu spu(GetParam());
  expect_fault(Rule::transfer_size, [&] { spu.dma(MFC_SDCRZ_CMD, 0, spu.ea(), 16385, 0); });
  expect_fault(Rule::effective_address, [&] { spu.dma(MFC_SDCRZ_CMD, 0, 128, 128, 0); });
}

TEST_P(EveryCheckedMode, refuses_lists_of_bad_size_place_or_alignment) {
  TestSpu spu(GetParam());
  expect_fault(Rule::list_size, [&] { spu.dma(MFC_GETL_CMD, 0x1000, spu.ea_low(0), 12, 0); });
  expect_fault(Rule::list_size, [&] { spu.dma(MFC_GETL_CMD, 0x1000, 0x2000, 2049 * 8, 0); });
  expect_fault(Rule::list_address, [&] { spu.dma(MFC_PUTL_CMD, 0x1000, 0x2004, 16, 0); });
  expect_fault(Rule::local_store_range, [&] { spu.dma(MFC_GETL_CMD, 0x1000, kLocalStoreSize - 8, 16, 0); });
}

TEST_P(EveryCheckedMode, refuses_illegal_list_elements) {
  TestSpu spu(GetParam());
  const std::uint64_t high = spu.ea() & ~std::uint64_t{0xffffffffU};
  const auto issue = [&](std::uint32_t first_word, std::uint32_t low, std::uint32_t ls = 0x4000) {
    spu.write_element(0x2000, 0, first_word, low);
    spu.dma(MFC_GETL_CMD, ls, high | 0x2000U, 8, 0);
  };
  expect_fault(Rule::transfer_size, [&] { issue(24, spu.ea_low(0)); });
  expect_fault(Rule::transfer_size, [&] { issue(0x4010, spu.ea_low(0)); });
  expect_fault(Rule::quadword_alignment, [&] { issue(32, spu.ea_low(8)); });
  expect_fault(Rule::natural_alignment, [&] { issue(4, spu.ea_low(2)); });
  expect_fault(Rule::local_store_range, [&] { issue(32, spu.ea_low(0), kLocalStoreSize - 16); });
  expect_fault(Rule::list_crosses_4_gb, [&] { issue(32, 0xfffffff0U); });
}

TEST(Rules, the_proxy_queue_takes_tags_to_15_and_plain_transfers_only) {
  TestSpu spu;
  CommandQueue proxy(spu.store, {Issuer::proxy, DmaMode::eager, 1, nullptr, nullptr});
  proxy.issue({MFC_GET_CMD, 15, 16, 0x1000, spu.ea(), {}});
  EXPECT_TRUE(spu.same(0x1000, 0, 16));
  expect_fault(Rule::tag, [&] { proxy.issue({MFC_GET_CMD, 16, 16, 0x1000, spu.ea(), {}}); });
  for (const std::uint32_t opcode :
       {MFC_GETL_CMD, MFC_PUTL_CMD, MFC_GETLLAR_CMD, MFC_SNDSIG_CMD, MFC_BARRIER_CMD}) {
    expect_fault(Rule::proxy_command, [&] { proxy.issue({opcode, 1, 16, 0x1000, spu.ea(), {}}); });
  }
}

TEST(Rules, only_whole_words_move_between_memory_of_different_byte_order) {
  TestSpu spu(DmaMode::eager, 1, WordOrder::swapped);
  expect_fault(Rule::word_transfer, [&] { spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 1, 0); });
  expect_fault(Rule::word_transfer, [&] { spu.dma(MFC_PUT_CMD, 0x1002, spu.ea(2), 2, 0); });
  spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), 4, 0);
}

TEST(Rules, a_fault_names_rule_addresses_size_tag_and_line) {
  TestSpu spu;
  const std::string text =
      expect_fault(Rule::transfer_size, [&] { spu.dma(MFC_PUTF_CMD, 0x1230, 0x7123456789a0U, 24, 7); });
  for (const char* part :
       {"transfer size", "putf", "0x01230", "0x7123456789a0", "24", "tag 7", "program.cpp:42"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
  }
}

TEST(Rules, faults_are_reported_with_the_stop_reasons_of_libspe2) {
  for (const Rule rule : {Rule::transfer_size, Rule::natural_alignment, Rule::quadword_alignment,
                          Rule::quadword_offset, Rule::list_address}) {
    EXPECT_EQ(stop_report(rule).reason, unsigned{SPE_RUNTIME_EXCEPTION});
    EXPECT_EQ(stop_report(rule).value, SPE_DMA_ALIGNMENT);
  }
  EXPECT_EQ(stop_report(Rule::effective_address).value, SPE_DMA_STORAGE);
  for (const Rule rule : {Rule::tag, Rule::opcode, Rule::list_size, Rule::local_store_range}) {
    EXPECT_EQ(stop_report(rule).reason, unsigned{SPE_RUNTIME_EXCEPTION});
    EXPECT_EQ(stop_report(rule).value, SPE_INVALID_DMA);
  }
  EXPECT_EQ(stop_report(Rule::channel).reason, unsigned{SPE_RUNTIME_ERROR});
  EXPECT_EQ(stop_report(Rule::channel).value, SPE_SPU_INVALID_CHANNEL);
  EXPECT_EQ(stop_report(Rule::local_store_full).reason, unsigned{SPE_RUNTIME_FATAL});
}

TEST(Rules, a_refused_command_has_no_effect) {
  TestSpu spu;
  expect_fault(Rule::quadword_alignment, [&] { spu.dma(MFC_GET_CMD, 0x1008, spu.ea(8), 16, 0); });
  for (std::uint32_t i = 0; i < 32; ++i) EXPECT_EQ(spu.peek(0x1000 + i), std::byte{0});
  EXPECT_EQ(spu.channels.count(MFC_Cmd), 16U);
}

TEST(Rules, unchecked_mode_has_no_rules_but_moves_the_same_bytes) {
  TestSpu spu(DmaMode::unchecked);
  spu.dma(MFC_GET_CMD, 0x1003, spu.ea(5), 20000, 77);
  EXPECT_TRUE(spu.same(0x1003, 5, 20000));
  spu.dma(MFC_PUT_CMD, 0x1003, spu.ea(30001), 37, 0);
  EXPECT_TRUE(spu.same(0x1003, 30001, 37));
}

TEST(Rules, addresses_of_64_bits_are_never_truncated) {
  TestSpu spu;
  ASSERT_NE(spu.ea() >> 32U, 0U) << "the test needs memory above 4 GB";
  spu.channels.write(MFC_LSA, 0x1000);
  spu.channels.write(MFC_EAH, static_cast<std::uint32_t>(spu.ea() >> 32U));
  spu.channels.write(MFC_EAL, static_cast<std::uint32_t>(spu.ea()));
  spu.channels.write(MFC_Size, 64);
  spu.channels.write(MFC_TagID, 2);
  spu.channels.write(MFC_Cmd, MFC_GET_CMD);
  EXPECT_TRUE(spu.same(0x1000, 0, 64));
}

}  // namespace
}  // namespace spu_emu
