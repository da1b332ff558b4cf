/// @file
/// Ctrl-C as a request: long work stops after the frame it is at and keeps what it has.
#pragma once

#include <csignal>

namespace cellsweep::report {

/// While one is there, the first Ctrl-C (SIGINT) is noted instead of ending the program; a second one ends
/// it. One at a time.
class InterruptScope {
 public:
  InterruptScope();
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;

 private:
  struct sigaction before_ {};
};

/// Whether there was a Ctrl-C in the scope that is there; false outside of scopes.
bool is_interrupted();

}  // namespace cellsweep::report
