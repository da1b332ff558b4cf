/// @file
/// Results of an experiment that never ran.
#pragma once

#include <string>
#include <string_view>

#include "report/experiment/experiment.h"

namespace cellsweep::report {

/// Every curve at 64, 512 and 1,024 boxes, each time 100 microseconds.
inline ExperimentResults made_up_results() {
  ExperimentResults results;
  results.settings.bodies = {64, 512, 1024};
  results.context = {{"cpu", "a machine of the mind"}, {"commit", "0123456789ab"}};
  for (const Curve& curve : curve_table()) {
    CurveResult result{curve, {}};
    for (const std::size_t bodies : results.settings.bodies) {
      for (const Measure measure : kAllMeasures) result.points[bodies][measure] = {100, 90, 110, 3};
    }
    results.curves.push_back(result);
  }
  return results;
}

/// Changes one median of a curve that is there.
inline void set_time(ExperimentResults& results, std::string_view curve, std::size_t bodies, Measure measure,
                     double microseconds) {
  for (CurveResult& result : results.curves) {
    if (result.curve.id == curve) result.points.at(bodies)[measure].median = microseconds;
  }
}

}  // namespace cellsweep::report
