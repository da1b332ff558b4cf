#include "engines/stream/rebuild_shares.h"

#include <algorithm>
#include <numeric>

namespace cellsweep::stream {
namespace {

/// What comes before the cells is done by then, and cells take so much of all updates at least: whatever the
/// clock says, no update of three compares more boxes than two thirds of all cells have.
constexpr double kDueBeforeCells = 0.5;
constexpr double kLeastOfCells = 0.5;

}  // namespace

bool RebuildShares::is_late(RebuildStage stage, double due) {
  return stage < kCells && due > kDueBeforeCells;
}

double RebuildShares::due_of(RebuildStage stage, double due) const {
  if (is_late(stage, due)) return 1;
  const double before = done_[stage - 1];
  const double share = done_[stage] - before;
  if (stage == kCells) {
    const double first = std::min(before, kDueBeforeCells);
    return std::clamp((due - first) / std::max(share, kLeastOfCells), 0.0, 1.0);
  }
  const double done = std::clamp((due - before) / share, 0.0, 1.0);
  return stage < kCells ? done : std::min(done, due_of(static_cast<RebuildStage>(stage - 1), due));
}

// Half of what is learnt is new. A stage in which the system took the core away counts for little more than
// before, and all stages get some.
void RebuildShares::learn() {
  constexpr double kLeast = 0.01;
  constexpr double kMost = 0.9;
  constexpr double kMoreAtMost = 0.1;
  const double all = std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
  if (!(all > 0)) return;
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
}

}  // namespace cellsweep::stream
