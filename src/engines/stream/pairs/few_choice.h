/// @file
/// Whether the cells are asked for the pairs of each body that changed.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/tuning.h"

namespace cellsweep::stream {

/// They are where that takes less than to walk all candidates. What waits from such updates has to be brought
/// into the list of these before it is walked again, which takes as long as some walks: so an update of a few
/// more does as they did, until what such ones took too much would have paid for it, as one rents until one
/// could have bought.
class FewChoice {
 public:
  /// Of an update in which so many bodies change, once: it counts. `waits`: something does.
  bool choose_few(std::size_t changed, std::size_t candidates, bool waits) {
    const std::size_t asked = changed * tuning::kCandidatesOfQuery;
    if (asked < candidates) {
      overrun_ -= std::min(overrun_, candidates - asked);
      return true;
    }
    overrun_ += asked - candidates;
    if (waits && asked < 2 * candidates && overrun_ <= tuning::kWalksOfWaiting * candidates) return true;
    overrun_ = 0;
    return false;
  }

 private:
  std::size_t overrun_ = 0;  // what asking took longer than walks would have, in candidates
};

}  // namespace cellsweep::stream
