#include "report/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>

namespace cellsweep::report {
namespace {

bool has_default_handler() {
  struct sigaction now {};
  sigaction(SIGINT, nullptr, &now);
  return now.sa_handler == SIG_DFL;
}

TEST(Interrupt, IsNotedInAScopeAndForgottenBehindIt) {
  {
    const InterruptScope scope;
    EXPECT_FALSE(is_interrupted());
    std::raise(SIGINT);
    EXPECT_TRUE(is_interrupted());
  }
  EXPECT_FALSE(is_interrupted());
  const InterruptScope next;
  EXPECT_FALSE(is_interrupted());
}

TEST(Interrupt, EndsTheProgramTheSecondTimeAndOutsideOfScopes) {
  {
    const InterruptScope scope;
    EXPECT_FALSE(has_default_handler());
    std::raise(SIGINT);
    EXPECT_TRUE(has_default_handler());
  }
  EXPECT_TRUE(has_default_handler());
}

TEST(Interrupt, IsASigtermToo) {
  const InterruptScope scope;
  EXPECT_EQ(interrupt_signal(), 0);
  std::raise(SIGTERM);
  EXPECT_TRUE(is_interrupted());
  EXPECT_EQ(interrupt_signal(), SIGTERM);
  EXPECT_STREQ(interrupt_name(), "SIGTERM");
}

TEST(Interrupt, StaysIgnoredWhereItWas) {
  std::signal(SIGINT, SIG_IGN);
  {
    const InterruptScope scope;
    std::raise(SIGINT);
    EXPECT_FALSE(is_interrupted());
  }
  EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_IGN);
}

}  // namespace
}  // namespace cellsweep::report
