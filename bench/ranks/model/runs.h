/// @file
/// What was measured over ranks, and the costs that the forecast takes from it.
#pragma once

#include <string>
#include <vector>

#include "cellsweep/status.h"
#include "ranks/model/model.h"

namespace cellsweep::ranks_bench {

/// A run of the benchmark: sums over ranks, a frame.
struct MeasuredRun {
  double bodies = 0;
  int ranks = 1;
  double ghosts = 0;
  double bytes = 0;
  double messages = 0;
  double enters = 0;
  double cpu_ms = 0;
};

/// Reads a list of what the benchmark prints. Errors: bad_input for one that is none.
Result<std::vector<MeasuredRun>> read_runs(const std::string& json);

/// The costs that come nearest to the runs: CPU times by least squares.
Costs fit(const std::vector<MeasuredRun>& runs);

/// Tables for the page: forecast beside what was measured, and forecasts for up to 10,000 ranks.
std::string measured_markdown(const std::vector<MeasuredRun>& runs, const Costs& costs);
std::string forecast_markdown(const Costs& costs);
/// The largest share by which a forecast of ghosts or bytes is off.
double largest_error(const std::vector<MeasuredRun>& runs, const Costs& costs);
/// What gnuplot draws of it, as a PNG on standard output.
std::string chart_script(const std::vector<MeasuredRun>& runs, const Costs& costs);

}  // namespace cellsweep::ranks_bench
