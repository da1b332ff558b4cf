#include "report/interrupt.h"

#include <atomic>

namespace cellsweep::report {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may use it");

extern "C" void note_interrupt(int) {
  interrupted = true;
}

}  // namespace

// Where the signal was ignored before, as of programs in the background, it still is.
InterruptScope::InterruptScope() {
  interrupted = false;
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, &before_);
  if (before_.sa_handler == SIG_IGN) sigaction(SIGINT, &before_, nullptr);
}

InterruptScope::~InterruptScope() {
  interrupted = false;
  sigaction(SIGINT, &before_, nullptr);
}

bool is_interrupted() {
  return interrupted;
}

}  // namespace cellsweep::report
