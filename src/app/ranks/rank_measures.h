/// @file
/// What the ranks do in each frame, and for how long.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/ranks/rank_run.h"
#include "cellsweep/ranks.h"

namespace cellsweep::app {

/// This rank's part of a report, until it is put together with those of the others.
class RankMeasures {
 public:
  /// From now on; all ranks begin together.
  explicit RankMeasures(bool with_timeline) : with_timeline_(with_timeline), start_ms_(now_ms()) {}

  /// Milliseconds of a clock that does not go back.
  static double now_ms();

  /// An update, with what came before it, from `begin` on: the handing over of bodies. Counted where it is
  /// told to be; in the timeline in any case.
  void add(const DistributedBroadphase& world, double begin, const RankPhase& hand_over, bool counted);

  void add_checkpoint(double milliseconds);
  std::size_t checkpoints() const { return checkpoints_; }

  /// Means over so many frames, of all ranks, which call it together, into their reports.
  void sum_up(const DistributedBroadphase& world, double frames, RankReport& report);

 private:
  void count(const DistributedBroadphase& world, const RankPhase& hand_over);
  void add_phase(const RankPhase& phase);
  void add_event(int rank, std::string_view name, double begin, double milliseconds);
  std::string gather_timeline(int ranks) const;

  bool with_timeline_;
  double start_ms_;
  std::vector<RankPhaseTimes> phases_;
  RankRow row_;
  double moves_ = 0;
  double enters_ = 0;
  double leaves_ = 0;
  double adoptions_ = 0;
  std::size_t checkpoints_ = 0;
  double checkpoint_ms_ = 0;
  std::string timeline_;
};

}  // namespace cellsweep::app
