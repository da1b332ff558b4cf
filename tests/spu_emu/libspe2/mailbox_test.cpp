// libspe2's side of mailboxes and signals.
#include <thread>

#include "../host/test_context.h"

namespace spu_emu {
namespace {

TEST(HostMailbox, a_non_blocking_write_writes_what_fits_and_says_how_many) {
  TestContext context;
  std::array<unsigned int, 6> messages{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(spe_in_mbox_status(context.spe), 4);
  EXPECT_EQ(spe_in_mbox_write(context.spe, messages.data(), 6, SPE_MBOX_ANY_NONBLOCKING), 4);
  EXPECT_EQ(spe_in_mbox_status(context.spe), 0);
  EXPECT_EQ(spe_in_mbox_write(context.spe, messages.data(), 1, SPE_MBOX_ANY_NONBLOCKING), 0);
}

TEST(HostMailbox, blocking_writes_and_reads_wait_for_the_program) {
  TestContext context;
  std::thread thread([&] { EXPECT_EQ(context.exit_code(Probe::echo_mailbox), 0); });
  std::array<unsigned int, 6> messages{2, 4, 6, 8, 10, 12};
  std::array<unsigned int, 6> answers{};
  std::thread writer(
      [&] { EXPECT_EQ(spe_in_mbox_write(context.spe, messages.data(), 6, SPE_MBOX_ALL_BLOCKING), 6); });
  EXPECT_EQ(spe_out_intr_mbox_read(context.spe, answers.data(), 1, SPE_MBOX_ANY_BLOCKING), 1);
  EXPECT_EQ(spe_out_intr_mbox_read(context.spe, answers.data() + 1, 5, SPE_MBOX_ALL_BLOCKING), 5);
  EXPECT_EQ(answers, (std::array<unsigned int, 6>{3, 5, 7, 9, 11, 13}));
  writer.join();
  unsigned int odd = 21;
  EXPECT_EQ(spe_in_mbox_write(context.spe, &odd, 1, SPE_MBOX_ANY_BLOCKING), 1);
  while (spe_out_mbox_status(context.spe) == 0) std::this_thread::yield();
  EXPECT_EQ(spe_out_mbox_read(context.spe, &odd, 1), 1);
  EXPECT_EQ(odd, 22U);
  unsigned int end = 0;
  spe_in_mbox_write(context.spe, &end, 1, SPE_MBOX_ALL_BLOCKING);
  thread.join();
}

TEST(HostMailbox, empty_boxes_give_no_messages) {
  TestContext context;
  unsigned int message = 0;
  EXPECT_EQ(spe_out_mbox_read(context.spe, &message, 1), 0);
  EXPECT_EQ(spe_out_mbox_status(context.spe), 0);
  EXPECT_EQ(spe_out_intr_mbox_read(context.spe, &message, 1, SPE_MBOX_ANY_NONBLOCKING), 0);
  EXPECT_EQ(spe_out_intr_mbox_status(context.spe), 0);
}

TEST(HostMailbox, bad_arguments_are_einval) {
  TestContext context;
  unsigned int message = 0;
  const auto is_einval = [](int result) { return result == -1 && std::exchange(errno, 0) == EINVAL; };
  EXPECT_TRUE(is_einval(spe_out_mbox_read(context.spe, nullptr, 1)));
  EXPECT_TRUE(is_einval(spe_out_mbox_read(context.spe, &message, 0)));
  EXPECT_TRUE(is_einval(spe_in_mbox_write(context.spe, nullptr, 1, SPE_MBOX_ALL_BLOCKING)));
  EXPECT_TRUE(is_einval(spe_in_mbox_write(context.spe, &message, -1, SPE_MBOX_ALL_BLOCKING)));
  EXPECT_TRUE(is_einval(spe_in_mbox_write(context.spe, &message, 1, 0)));
  EXPECT_TRUE(is_einval(spe_out_intr_mbox_read(context.spe, &message, 1, 4)));
  EXPECT_TRUE(is_einval(spe_signal_write(context.spe, 3, 0)));
}

TEST(HostMailbox, signals_reach_the_program_in_the_mode_of_the_context) {
  TestContext overwrite;
  TestContext collect({}, SPE_CFG_SIGNOTIFY1_OR | SPE_CFG_SIGNOTIFY2_OR);
  for (spe_context_ptr_t spe : {overwrite.spe, collect.spe}) {
    EXPECT_EQ(spe_signal_write(spe, SPE_SIG_NOTIFY_REG_1, 1), 0);
    EXPECT_EQ(spe_signal_write(spe, SPE_SIG_NOTIFY_REG_1, 2), 0);
    EXPECT_EQ(spe_signal_write(spe, SPE_SIG_NOTIFY_REG_2, 16), 0);
  }
  EXPECT_EQ(overwrite.exit_code(Probe::answer_to_signal), 18);
  EXPECT_EQ(collect.exit_code(Probe::answer_to_signal), 19);
}

}  // namespace
}  // namespace spu_emu
