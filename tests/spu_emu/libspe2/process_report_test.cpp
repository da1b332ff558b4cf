// Who waits for what, and the time limit of a process.
#include "spe/process_report.h"

#include <cstdlib>
#include <thread>

#include "../host/test_context.h"

namespace spu_emu {
namespace {

std::string report_that_has(const std::string& words) {
  std::string report;
  do {
    std::this_thread::yield();
    report = process_report();
  } while (report.find(words) == std::string::npos);
  return report;
}

TEST(ProcessReport, tells_what_a_program_and_a_thread_of_the_host_wait_for) {
  TestContext context;
  EXPECT_NE(process_report().find("stands still: the host does not run it"), std::string::npos);
  std::thread thread([&] { EXPECT_EQ(context.exit_code(Probe::echo_mailbox), 0); });
  EXPECT_NE(report_that_has("read in mailbox").find("in mailbox 0 of 4, out mailbox 0 of 1"),
            std::string::npos);
  unsigned int answer = 0;
  std::thread reader([&] { spe_out_intr_mbox_read(context.spe, &answer, 1, SPE_MBOX_ALL_BLOCKING); });
  EXPECT_NE(report_that_has("the host waits").find("s in spe_out_intr_mbox_read of SPE "), std::string::npos);
  std::array<unsigned int, 2> messages{2, 0};
  spe_in_mbox_write(context.spe, messages.data(), 2, SPE_MBOX_ALL_BLOCKING);
  reader.join();
  thread.join();
  EXPECT_EQ(answer, 3U);
  EXPECT_EQ(process_report().find("the host waits"), std::string::npos);
}

/// Each in a process of its own: the limit is read once.
class ProcessTimeLimit : public testing::Test {
 protected:
  ProcessTimeLimit() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }

  static void hang_with(const char* limit) {
    setenv("SPU_EMU_PROCESS_TIME_LIMIT", limit, 1);
    const TestContext context;
    for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
  }
};

TEST_F(ProcessTimeLimit, ends_a_process_and_says_who_waits) {
  EXPECT_EXIT(hang_with("0.05"), testing::ExitedWithCode(124),
              "0.05 s are over, and the program has not ended:\nSPE 0 stands still");
}

TEST_F(ProcessTimeLimit, that_is_no_number_above_zero_is_refused) {
  for (const char* limit : {"soon", "0", "-1", "1s", "nan", "1e99"}) {
    EXPECT_EXIT(hang_with(limit), testing::ExitedWithCode(124), "is no number of seconds above 0") << limit;
  }
}

}  // namespace
}  // namespace spu_emu
