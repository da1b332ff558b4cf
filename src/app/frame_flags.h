/// @file
/// The flags that say how many frames to run and what of them to report.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>

#include "report/run_engine.h"

namespace cellsweep::app {

/// Adds --frames, --report-frames and --json to a command.
struct FrameFlags {
  /// `frames_default` is the number of updates after frame 0 when none is given.
  void add_to(CLI::App& command, std::size_t frames_default, const std::string& frames_text);

  report::RunSettings settings;
  bool json = false;
};

}  // namespace cellsweep::app
