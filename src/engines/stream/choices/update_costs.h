/// @file
/// What updates of engine `stream` take, learnt from those before, and what follows for the next.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/threads/work_cost.h"
#include "base/tuning.h"

namespace cellsweep::stream {

/// Of a body that moved, as to whether it left its fat box; of one when everything is found anew, and of one
/// whose fat box changed.
struct UpdateCosts {
  WorkCost looked_at{tuning::kMoveGuess};
  WorkCost full{tuning::kFullGuess};
  WorkCost partial{tuning::kPartialGuess};

  /// Up to how many changes of fat boxes an update would rather look at one by one.
  std::size_t most_listed(std::size_t bodies) const {
    const double share =
        std::clamp(full.seconds() / partial.seconds(), tuning::kLeastShare, tuning::kMostShare);
    return static_cast<std::size_t>(static_cast<double>(bodies) * share);
  }
};

}  // namespace cellsweep::stream
