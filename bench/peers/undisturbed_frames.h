/// @file
/// Frames in which the operating system took no core from the process.
#pragma once

#include <sys/resource.h>

#include <vector>

namespace cellsweep::bench {

class UndisturbedFrames {
 public:
  /// Does a frame, which returns the seconds that it took, and keeps these if it was left alone.
  template <class Frame>
  double add(const Frame& frame) {
    const long switches = involuntary_switches();
    const double seconds = frame();
    if (involuntary_switches() == switches) seconds_.push_back(seconds);
    return seconds;
  }

  const std::vector<double>& seconds() const { return seconds_; }

 private:
  // Of all threads of the process.
  static long involuntary_switches() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_nivcsw;
  }

  std::vector<double> seconds_;
};

}  // namespace cellsweep::bench
