/// @file
/// What the command's exit code says.
#pragma once

#include "cellsweep/status.h"

namespace cellsweep::app {

enum ExitCode : int {
  kGood = 0,
  kResultsDiffer = 1,
  kBadUsage = 2,       ///< bad arguments or bad input
  kCapacity = 3,       ///< more than an engine holds
  kSpeFailed = 4,      ///< an SPE broke a rule of the hardware, or could not be started
  kNoDisplay = 5,      ///< `view` found no display with OpenGL 3.3
  kOutputLost = 6,     ///< standard output or a file could not be written whole
  kNoMemory = 7,       ///< the system gave no more memory or threads
  kInterrupted = 130,  ///< stopped by Ctrl-C (SIGINT); what there was is written
  kTerminated = 143,   ///< stopped by SIGTERM; what there was is written
};

/// The exit code for a status that is not ok.
inline ExitCode exit_code_of(const Status& status) {
  switch (status.code) {
    case StatusCode::capacity:
      return kCapacity;
    case StatusCode::spe_failed:
      return kSpeFailed;
    case StatusCode::write_failed:
      return kOutputLost;
    default:
      return kBadUsage;
  }
}

}  // namespace cellsweep::app
