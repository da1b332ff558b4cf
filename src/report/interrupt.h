/// @file
/// Ctrl-C, and SIGTERM, as a request: long work stops after the frame it is at and keeps what it has.
#pragma once

#include <csignal>

namespace cellsweep::report {

/// While one is there, the first Ctrl-C (SIGINT) or SIGTERM is noted instead of ending the program; a second
/// one ends it. One at a time.
class InterruptScope {
 public:
  InterruptScope();
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

/// Whether there was a Ctrl-C or SIGTERM in the scope that is there; false outside of scopes.
bool is_interrupted();

/// Which of the two it was, SIGINT or SIGTERM; 0 for none.
int interrupt_signal();

/// "Ctrl-C" or "SIGTERM".
const char* interrupt_name();

}  // namespace cellsweep::report
