/// @file
/// What the command's exit code says.
#pragma once

#include "cellsweep/status.h"

namespace cellsweep::app {

enum ExitCode : int {
  kGood = 0,
  kResultsDiffer = 1,
  kBadUsage = 2,  ///< bad arguments or bad input
  kCapacity = 3,  ///< more than an engine holds
};

/// The exit code for a status that is not ok.
inline ExitCode exit_code_of(const Status& status) {
  return status.code == StatusCode::capacity ? kCapacity : kBadUsage;
}

}  // namespace cellsweep::app
