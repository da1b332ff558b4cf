#include "engines/stream/rebuild_shares.h"

#include <algorithm>
#include <numeric>

namespace cellsweep::stream {

double RebuildShares::due_of(RebuildStage stage, double due) const {
  const double before = done_[stage - 1];
  return std::clamp((due - before) / (done_[stage] - before), 0.0, 1.0);
}

// Half of what is learnt is new. A stage in which the system took the core away counts for little more than
// before. Whatever the clock says, no update of three compares more boxes than two thirds of all cells have,
// and all stages get some.
void RebuildShares::learn() {
  constexpr double kLeast = 0.01;
  constexpr double kLeastOfCells = 0.5;
  constexpr double kMost = 0.9;
  constexpr double kMoreAtMost = 0.1;
  const double all = std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
  if (!(all > 0)) return;
  Stages shares{};
  for (int stage = kFatBoxes; stage <= kAll; ++stage) {
    const double before = done_[stage] - done_[stage - 1];
    const double most = std::min(before + kMoreAtMost, kMost);
    const double least = stage == kCells ? kLeastOfCells : kLeast;
    shares[stage] = std::max(std::min((before + seconds_[stage] / all) / 2, most), least);
  }
  const double of_others = std::accumulate(shares.begin(), shares.end(), -shares[kCells]);
  for (int stage = kFatBoxes; stage <= kAll; ++stage)
    if (stage != kCells) shares[stage] *= (1 - shares[kCells]) / of_others;
  std::partial_sum(shares.begin(), shares.end(), done_.begin());
  done_.back() = 1;
}

}  // namespace cellsweep::stream
