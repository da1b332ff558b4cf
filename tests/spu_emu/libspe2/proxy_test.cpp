// Proxy DMA: the host moves bytes into and out of a local store through the MFC.
#include <cstring>
#include <thread>

#include "../host/test_context.h"

namespace spu_emu {
namespace {

constexpr unsigned int kBuffer = 0x20000;

class Proxy : public testing::TestWithParam<DmaMode> {};
INSTANTIATE_TEST_SUITE_P(Modes, Proxy, testing::Values(DmaMode::eager, DmaMode::late, DmaMode::unchecked));

TEST_P(Proxy, moves_bytes_both_ways_with_every_variant) {
  TestContext context(settings_of(GetParam()));
  using Transfer = decltype(&spe_mfcio_get);
  for (const Transfer get : {&spe_mfcio_get, &spe_mfcio_getb, &spe_mfcio_getf}) {
    for (const Transfer put : {&spe_mfcio_put, &spe_mfcio_putb, &spe_mfcio_putf}) {
      Words from;
      Words to;
      to.words.fill(0);
      unsigned int status = 0;
      EXPECT_EQ(get(context.spe, kBuffer, &from, sizeof from, 3, 0, 0), 0);
      EXPECT_EQ(spe_mfcio_tag_status_read(context.spe, 1U << 3, SPE_TAG_ALL, &status), 0);
      EXPECT_EQ(status, 1U << 3);
      EXPECT_EQ(put(context.spe, kBuffer, &to, sizeof to, 4, 0, 0), 0);
      EXPECT_EQ(spe_mfcio_tag_status_read(context.spe, 0, SPE_TAG_ANY, &status), 0);
      EXPECT_EQ(status, 1U << 4);
      EXPECT_EQ(to.words, from.words);
    }
  }
  EXPECT_EQ(statistics(context.spe).proxy_gets, 9U);
  EXPECT_EQ(statistics(context.spe).proxy_puts, 9U);
}

TEST_P(Proxy, reaches_globals_by_the_address_that_the_program_sends) {
  TestContext context(settings_of(GetParam()));
  Words words;
  std::thread program([&] {
    EXPECT_EQ(context.exit_code(Probe::send_global_and_wait), static_cast<int>(words.words[5] + 1));
  });
  unsigned int address = 0;
  while (spe_out_mbox_read(context.spe, &address, 1) == 0) std::this_thread::yield();
  unsigned int status = 0;
  EXPECT_EQ(spe_mfcio_get(context.spe, address, &words, sizeof words, 3, 0, 0), 0) << last_fault(context.spe);
  EXPECT_EQ(spe_mfcio_tag_status_read(context.spe, 1U << 3, SPE_TAG_ALL, &status), 0);
  unsigned int go = 1;
  EXPECT_EQ(spe_in_mbox_write(context.spe, &go, 1, SPE_MBOX_ALL_BLOCKING), 1);
  program.join();
  Words back;
  EXPECT_EQ(spe_mfcio_put(context.spe, address, &back, sizeof back, 3, 0, 0), 0) << last_fault(context.spe);
  EXPECT_EQ(spe_mfcio_tag_status_read(context.spe, 1U << 3, SPE_TAG_ALL, &status), 0);
  EXPECT_EQ(back.words[7], words.words[7] + 1);
}

TEST_P(Proxy, asking_at_once_ends_when_repeated) {
  TestContext context(settings_of(GetParam()));
  Words from;
  unsigned int status = 0;
  spe_mfcio_get(context.spe, kBuffer, &from, sizeof from, 3, 0, 0);
  int polls = 0;
  while (status != 1U << 3) {
    ASSERT_EQ(spe_mfcio_tag_status_read(context.spe, 1U << 3, SPE_TAG_IMMEDIATE, &status), 0);
    ASSERT_LT(++polls, 1000);
  }
  EXPECT_EQ(std::memcmp(static_cast<char*>(spe_ls_area_get(context.spe)) + kBuffer, &from, sizeof from), 0);
}

TEST(ProxyErrors, tags_above_15_and_bad_arguments_are_einval) {
  TestContext context;
  Words words;
  unsigned int status = 0;
  const auto is_einval = [](int result) { return result == -1 && std::exchange(errno, 0) == EINVAL; };
  EXPECT_TRUE(is_einval(spe_mfcio_get(context.spe, kBuffer, &words, 128, 16, 0, 0)));
  EXPECT_TRUE(is_einval(spe_mfcio_get(context.spe, kBuffer, &words, 128, 0, 256, 0)));
  EXPECT_TRUE(is_einval(spe_mfcio_put(context.spe, kBuffer, &words, 128, 0, 0, 256)));
  EXPECT_TRUE(is_einval(spe_mfcio_tag_status_read(context.spe, 1, 0, &status)));
  EXPECT_TRUE(is_einval(spe_mfcio_tag_status_read(context.spe, 1, SPE_TAG_ALL, nullptr)));
}

TEST(ProxyErrors, a_broken_rule_is_eio_and_explained) {
  TestContext context;
  Words words;
  EXPECT_EQ(spe_mfcio_put(context.spe, kBuffer + 4, &words, 128, 1, 0, 0), -1);
  EXPECT_EQ(errno, EIO);
  EXPECT_NE(last_fault(context.spe).find("alignment"), std::string::npos);
  EXPECT_EQ(spe_mfcio_get(context.spe, 0x3fff0, &words, 128, 1, 0, 0), -1);
  EXPECT_EQ(errno, EIO);
}

}  // namespace
}  // namespace spu_emu
