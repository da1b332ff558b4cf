/// @file
/// Where engine `stream`, the one to use, stands among the engines that were measured.
#pragma once

#include <string>

#include "report/experiment/experiment.h"

namespace cellsweep::report {

/// Sentences: its frame with the most boxes, and how that compares with the fastest of the others and with
/// `control`. Empty when `stream`, or everything else, was not measured.
std::string standing_text(const ExperimentResults& results, Measure measure);

}  // namespace cellsweep::report
