#include "report/interrupt.h"

#include <atomic>

namespace cellsweep::report {
namespace {

std::atomic<int> noted = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may use it");

extern "C" void note_interrupt(int signal) {
  noted = signal;
}

// Where the signal was ignored before, as of programs in the background, it still is.
void note(int signal, struct sigaction& before) {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(signal, &action, &before);
  if (before.sa_handler == SIG_IGN) sigaction(signal, &before, nullptr);
}

}  // namespace

InterruptScope::InterruptScope() {
  noted = 0;
  note(SIGINT, interrupt_before_);
  note(SIGTERM, terminate_before_);
}

InterruptScope::~InterruptScope() {
  noted = 0;
  sigaction(SIGINT, &interrupt_before_, nullptr);
  sigaction(SIGTERM, &terminate_before_, nullptr);
}

bool is_interrupted() {
  return noted != 0;
}

int interrupt_signal() {
  return noted;
}

const char* interrupt_name() {
  return noted == SIGTERM ? "SIGTERM" : "Ctrl-C";
}

}  // namespace cellsweep::report
