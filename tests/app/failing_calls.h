/// @file
/// Runs the command while chosen calls of the system's library fail, or it is killed before one.
#pragma once

#include <string>

#include "command_line.h"

namespace cellsweep::app {

/// Where in a run what is to happen.
struct CallPlan {
  std::string kind;  ///< one that failing_calls.cpp knows
  long number = 0;   ///< of the calls of this kind, from 1 on
  std::string what;  ///< "5" for EIO, "short", "signal-9"
  bool and_later = false;
};

/// False where nothing can be preloaded: beneath a sanitizer, or through an emulator.
bool can_fail_calls();

/// Runs `cellsweep ARGUMENTS` by that plan.
CommandResult run_failing(const std::string& arguments, const CallPlan& plan);

/// How many calls of a kind a run makes that nothing happens to.
long calls_of(const std::string& kind, const std::string& arguments);

}  // namespace cellsweep::app
