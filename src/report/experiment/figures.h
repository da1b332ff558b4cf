/// @file
/// The figures of the experiment: which curves, which time (E2-E5).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/experiment/experiment.h"

namespace cellsweep::report {

/// One figure; its files are called by its id.
struct Figure {
  std::string_view id;
  std::string_view title;
  std::string_view document;  ///< the figure of the document that it redoes; empty for one of our own
  std::string_view caption;   ///< a sentence: what is shown
  std::string_view y_label;
  Measure measure = Measure::initial;
  std::string_view
      curves;  ///< the ids that it shows, a blank between two; empty: whole frames and the simulated Cell
  bool with_spu_part = false;  ///< whole frames, and the part of the SPUs
};

std::span<const Figure> figure_table();

/// The curves of a figure that were measured, in the order of the curve table.
std::vector<const CurveResult*> curves_of(const Figure& figure, const ExperimentResults& results);

}  // namespace cellsweep::report
