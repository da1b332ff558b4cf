/// @file
/// Which bodies of a scene or recording this rank has.
#pragma once

#include <span>
#include <vector>

#include "cellsweep/ranks.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep::app {

/// The bodies that this rank hands over: new ones in turn, others where they are owned.
class OwnBodies {
 public:
  OwnBodies(int rank, int ranks) : rank_(rank), ranks_(ranks) {}

  /// Removes, moves and inserts this rank's part of a frame.
  Status hand_over(const FrameSource& source, std::span<const BodyId> inserted, DistributedBroadphase& world);

  /// The bodies of a world that goes on.
  void adopt(std::span<const GlobalId> owned);

  /// What the update after hand_over() said.
  void take_over(const RankChanges& changes);

 private:
  bool is_mine(BodyId id) const { return id < mine_.size() && mine_[id]; }
  void set(GlobalId id, bool mine);
  template <class IsChosen>
  void choose(const FrameSource& source, std::span<const BodyId> from, const IsChosen& is_chosen);
  Status insert(const FrameSource& source, std::span<const BodyId> inserted, DistributedBroadphase& world);
  Status move(const FrameSource& source, DistributedBroadphase& world);
  Status remove(const FrameSource& source, DistributedBroadphase& world);

  int rank_;
  int ranks_;
  std::vector<bool> mine_;
  std::vector<GlobalId> ids_;
  std::vector<Aabb> boxes_;
  std::vector<BodyFilter> filters_;
};

}  // namespace cellsweep::app
