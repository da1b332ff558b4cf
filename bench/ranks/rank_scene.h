/// @file
/// A world of flying bodies of which each rank moves those that it owns, as a simulation over MPI does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/ranks.h"
#include "cellsweep/world/scene.h"

namespace cellsweep::ranks_bench {

/// Positions of all bodies of a scene, of which a rank keeps those up to date that it moves itself.
class RankScene {
 public:
  explicit RankScene(const SceneSettings& settings);

  std::size_t bodies() const { return boxes_.size(); }
  std::span<const Aabb> boxes() const { return boxes_; }

  /// Moves these bodies, of `ids`, by one frame and writes their boxes to `moved`. A body that leaves the
  /// room turns back.
  void move(std::span<const GlobalId> ids, std::vector<Aabb>& moved);

  /// A body comes from another rank, which says where it is.
  struct Flight {
    Aabb box;
    Point velocity;
  };
  const Flight flight(GlobalId id) const { return {boxes_[id], velocities_[id]}; }
  void set_flight(GlobalId id, const Flight& flight);

  /// Those of the bodies that move at all.
  bool moves(GlobalId id) const;

 private:
  Aabb room_;
  std::vector<Aabb> boxes_;
  std::vector<Point> velocities_;
};

}  // namespace cellsweep::ranks_bench
