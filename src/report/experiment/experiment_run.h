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

/// The options of an engine on a simulated Cell.
EngineOptions simulated_cell();

/// The frames of each kind in a run.
std::size_t frames_of_kind(bool simulated, const ExperimentSettings& settings);

/// Times in microseconds; of parts that the engine does not tell they are 0.
struct ExperimentRun {
  std::array<PerMeasure<double>, kParts> times;  ///< by Part
  std::vector<Step> initial_steps;
  std::vector<Step> moving_steps;
  std::size_t pairs = 0;
  bool exact = false;  ///< ended with the oracle's pairs
};

/// All boxes into new engines a few times, once on a simulated Cell; then frames with nothing moving, then
/// frames with some moving. `frame_done` is called after each frame. Errors: those of the engine.
Result<ExperimentRun> run_through_experiment(const std::string& engine, bool simulated, std::size_t bodies,
                                             const ExperimentSettings& settings,
                                             const std::function<void()>& frame_done);

}  // namespace cellsweep::report
