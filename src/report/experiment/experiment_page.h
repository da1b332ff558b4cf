/// @file
/// What the experiment leaves behind: CSV, SVG and PNG of every figure, and a page that holds it all.
#pragma once

#include <filesystem>
#include <string>

#include "report/experiment/experiment.h"

namespace cellsweep::report {

/// Draws a picture of the scene at its middle frame. Errors: those of trace_picture() and write_png().
Status draw_scene(const ExperimentSettings& settings, bool quick, const std::filesystem::path& path);

/// Writes ID.csv, ID.gnuplot, ID.svg and ID.png of every figure with a curve, and report.html, which shows
/// `picture` (a PNG file; none if empty). The folder must be there. Errors: those of write_text_file(), and
/// bad_input for a gnuplot that fails.
Status write_experiment(const ExperimentResults& results, const std::filesystem::path& folder,
                        const std::filesystem::path& picture);

}  // namespace cellsweep::report
