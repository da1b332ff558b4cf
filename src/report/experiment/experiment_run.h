/// @file
/// One engine taken through the experiment once.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "cellsweep/engines.h"
#include "cellsweep/status.h"
#include "report/experiment/experiment.h"

namespace cellsweep::report {

/// The settings of an engine, with default options or on a simulated Cell.
SettingValues settings_of_engine(bool simulated);

/// The frames of each kind in a run.
std::size_t frames_of_kind(bool simulated, const ExperimentSettings& settings);

/// Times in microseconds; of parts that the engine does not tell they are 0.
struct ExperimentRun {
  std::array<PerMeasure<double>, kParts> times;  ///< by Part
  std::vector<Step> initial_steps;
  std::vector<Step> moving_steps;
  std::size_t pairs = 0;
  bool exact = false;     ///< ended with the oracle's pairs
  bool complete = false;  ///< false for one that was interrupted, of which there is nothing else
};

/// All boxes into new engines a few times, once on a simulated Cell; then frames with nothing moving, then
/// frames with some moving. `frame_done` is called after each frame; an interrupted run ends there. Errors:
/// those of the engine.
Result<ExperimentRun> run_through_experiment(const std::string& engine, bool simulated, std::size_t bodies,
                                             const ExperimentSettings& settings,
                                             const std::function<void()>& frame_done);

}  // namespace cellsweep::report
