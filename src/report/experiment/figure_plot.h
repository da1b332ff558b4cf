/// @file
/// A figure as a gnuplot script that draws it as SVG and PNG.
#pragma once

#include <string>

#include "report/experiment/figures.h"

namespace cellsweep::report {

/// A script that writes ID.svg and ID.png into its working directory; the numbers are in it.
std::string figure_script(const Figure& figure, const ExperimentResults& results);

}  // namespace cellsweep::report
