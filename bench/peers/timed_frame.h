/// @file
/// What a frame took, and whether the operating system took a core from the process meanwhile.
#pragma once

#include <sys/resource.h>

namespace cellsweep::bench {

struct TimedFrame {
  double seconds;
  bool is_undisturbed;
};

/// Involuntary switches of all threads of the process.
inline long involuntary_switches() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_nivcsw;
}

/// Does a frame, which returns the seconds that it took.
template <class Frame>
TimedFrame time_frame(const Frame& frame) {
  const long switches = involuntary_switches();
  const double seconds = frame();
  return {seconds, involuntary_switches() == switches};
}

}  // namespace cellsweep::bench
