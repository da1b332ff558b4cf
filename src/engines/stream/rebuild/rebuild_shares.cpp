#include "engines/stream/rebuild/rebuild_shares.h"

#include <algorithm>
#include <numeric>

namespace cellsweep::stream {

// Where they take little, as much earlier than they would begin as they end later.
double RebuildShares::first_of_cells() const {
  const double before = done_[kCells - 1];
  const double after = done_[kCells];
  if (after - before >= least_of_cells_) return before;
  return std::max(std::min((before + after - least_of_cells_) / 2, 1 - least_of_cells_), 0.0);
}

double RebuildShares::due_of(RebuildStage stage, double due) const {
  if (due >= 1 || is_late(stage, due)) return 1;
  const double before = done_[stage - 1];
  const double share = done_[stage] - before;
  if (stage == kCells)
    return std::clamp((due - first_of_cells()) / std::max(share, least_of_cells_), 0.0, 1.0);
  const double done = std::clamp((due - before) / share, 0.0, 1.0);
  return stage < kCells ? done : std::min(done, due_of(static_cast<RebuildStage>(stage - 1), due));
}

// Half of what is learnt is new. A stage in which the system took the core away counts for little more than
// before, and all stages get some.
double RebuildShares::learn() {
  constexpr double kLeast = 0.01;
  constexpr double kMost = 0.9;
  constexpr double kMoreAtMost = 0.1;
  const double all = std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
  if (!(all > 0)) return 0;
  mean_ = mean_ > 0 ? (mean_ + all) / 2 : all;
  Stages shares{};
  for (int stage = kFatBoxes; stage <= kAll; ++stage) {
    const double before = done_[stage] - done_[stage - 1];
    const double most = std::min(before + kMoreAtMost, kMost);
    shares[stage] = std::max(std::min((before + seconds_[stage] / all) / 2, most), kLeast);
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share /= sum;
  std::partial_sum(shares.begin(), shares.end(), done_.begin());
  done_.back() = 1;
  return all;
}

}  // namespace cellsweep::stream
