/// @file
/// Whether what the document found (5.1-5.3) holds for the times measured here.
#pragma once

#include <string>
#include <vector>

#include "report/experiment/experiment.h"

namespace cellsweep::report {

enum class Verdict { holds, fails, unknown };

/// One of the document's findings, judged.
struct Finding {
  std::string figure;   ///< the id of the figure that shows it
  std::string claim;    ///< what the document says
  std::string chapter;  ///< where it says so
  Verdict verdict = Verdict::unknown;
  std::string text;  ///< the numbers and what follows from them, for a person
};

/// The five findings, in the document's order. One whose curves or sizes were not measured is `unknown`.
std::vector<Finding> judge(const ExperimentResults& results);

/// "holds here", "does not hold here", "cannot be judged here".
std::string verdict_text(Verdict verdict);

}  // namespace cellsweep::report
