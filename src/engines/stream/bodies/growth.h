/// @file
/// How far fat boxes reach.
#pragma once

#include "base/tuning.h"

namespace cellsweep::stream {

struct Growth {
  /// The way a body goes at least, in lengths of its box.
  float least = tuning::kLeastGrowth;
  /// To either side by one that trembles: so many times its last step,
  float updates = tuning::kTrembleAhead;
  /// and so many times the step by which it was known to tremble, a length halved so often at least.
  float steps = tuning::kStepsOfTrembling;
  int most_halvings = tuning::kMostHalvings;
  /// Where that did not last, so many halvings less.
  int raise = tuning::kRaise;
};

}  // namespace cellsweep::stream
