/// @file
/// How the work of a rebuild is shared among updates.
#pragma once

#include <array>
#include <cstdint>

#include "engines/stream/rebuild/rebuild_pace.h"

namespace cellsweep::stream {

/// What of a rebuild is done.
enum RebuildStage { kNothing, kBegun, kFatBoxes, kListed, kFilled, kCells, kMended, kCounted, kAll };

/// How much of the work is done with each stage, by what the last rebuilds took: that differs with the world,
/// with its size and with how much of it the caches hold.
class RebuildShares {
 public:
  /// Where so much of the work is due, 0 to 1: whether a stage is, that is not cut. It is done in the update
  /// that has more than half of it to do.
  bool is_due(RebuildStage stage, double due) const {
    return (done_[stage - 1] + done_[stage]) / 2 <= due || is_late(stage, due);
  }
  /// How much of a stage is, 0 to 1.
  double due_of(RebuildStage stage, double due) const;

  /// A rebuild in so many parts begins, whatever became of the last one.
  void begin(std::uint32_t parts) {
    seconds_ = {};
    least_of_cells_ = kPartsOfCells * RebuildPace::most_of_part(parts) / parts;
  }
  /// A part of a stage took so long.
  void note(RebuildStage stage, double seconds) { seconds_[stage] += seconds; }
  /// All stages are done. Returns what they took, in seconds.
  [[gnu::cold]] double learn();
  /// What rebuilds took in the mean, the last ones more than others; 0 before the first one.
  double seconds() const { return mean_; }

 private:
  using Stages = std::array<double, kAll + 1>;

  /// Cells take so many of the longest parts at least: whatever the clock says, no update compares more boxes
  /// than two thirds of all cells have.
  static constexpr double kPartsOfCells = 1.5;

  /// What comes before the cells is done when they begin.
  bool is_late(RebuildStage stage, double due) const { return stage < kCells && due > first_of_cells(); }
  double first_of_cells() const;

  // At first as in uniform, between 10,000 and 100,000, on a Xeon.
  Stages done_ = {0, 0, 0.19, 0.31, 0.52, 0.74, 0.88, 0.94, 1};
  Stages seconds_{};  // that each stage took in this rebuild
  double mean_ = 0;
  double least_of_cells_ = 0.5;
};

}  // namespace cellsweep::stream
