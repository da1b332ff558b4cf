/// @file
/// The CPU time of the calling thread.
#pragma once

#include <ctime>

namespace cellsweep {

/// Milliseconds that the calling thread has computed, whatever else the machine did meanwhile.
inline double thread_cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

}  // namespace cellsweep
