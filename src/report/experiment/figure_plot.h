/// @file
/// A figure as a gnuplot script that draws it as SVG and PNG.
#pragma once

#include <string>

#include "report/experiment/figures.h"

namespace cellsweep::report {

/// The two kinds of pictures of a figure.
enum class Drawing { svg, png };

/// A script that writes ID.svg and ID.png into its working directory; the numbers are in it.
std::string figure_script(const Figure& figure, const ExperimentResults& results);

/// A script that writes the same picture to standard output.
std::string drawing_script(const Figure& figure, const ExperimentResults& results, Drawing drawing);

}  // namespace cellsweep::report
