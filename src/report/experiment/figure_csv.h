/// @file
/// A figure's numbers as a CSV file.
#pragma once

#include <string>

#include "report/experiment/figures.h"

namespace cellsweep::report {

/// Lines "# name: value" with the machine, the build, the settings and the units, then one row a curve and
/// size: figure,curve,engine,part,bodies,median_us,lowest_us,highest_us,repetitions. Times in microseconds.
std::string figure_csv(const Figure& figure, const ExperimentResults& results);

/// Names and values of what the experiment was run with, for a person.
std::vector<std::pair<std::string, std::string>> settings_of(const ExperimentSettings& settings);

}  // namespace cellsweep::report
