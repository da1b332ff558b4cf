/// @file
/// The one clock of frames: what handing bodies over and update() took, part by part.
#pragma once

#include <functional>
#include <vector>

#include "cellsweep/broadphase.h"

namespace cellsweep::report {

/// Milliseconds on the wall, but for `cpu_ms`.
struct FrameTime {
  double total_ms = 0;
  double setup_ms = 0;          ///< of all, phases that are done once per body ever inserted
  double spes_ms = 0;           ///< of all, while SPEs worked
  double cpu_ms = 0;            ///< CPU time of the calling thread
  std::vector<Phase> phases{};  ///< as the engine tells them

  /// What a frame is said to take: all but set-up.
  double work_ms() const { return total_ms - setup_ms; }
};

/// What an update found, valid as long as PairChanges says, and what it took.
struct TimedFrame {
  PairChanges changes;
  FrameTime time;
};

/// Hands over, then updates. Errors: those of both.
Result<TimedFrame> time_frame(Broadphase& engine, const std::function<Status()>& hand_over);

/// For frames in which nothing changes.
inline Status hand_over_nothing() {
  return {};
}

}  // namespace cellsweep::report
