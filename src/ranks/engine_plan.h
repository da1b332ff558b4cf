/// @file
/// What the next update does to this rank's engine, on top of the moves that its callers made themselves.
#pragma once

#include <cstddef>
#include <vector>

#include "cellsweep/broadphase.h"
#include "ranks/held_bodies.h"

namespace cellsweep::ranks {

class EnginePlan {
 public:
  bool empty() const { return removed_.size() + inserted_.size() + filtered_.size() + moved_.size() == 0; }
  std::size_t inserted() const { return inserted_.size(); }
  std::size_t removed() const { return removed_.size(); }

  /// Room for so many of each kind: what follows cannot fail then.
  void reserve(std::size_t bodies);
  void remove(Local local) { removed_.push_back(local); }
  void insert(Local local, const Aabb& box, const BodyFilter& filter);
  void set_filter(Local local, const BodyFilter& filter);
  void move(Local local, const Aabb& box);

  /// Does it, and forgets it. What was done when it fails or throws is not done again by the next call.
  Status run(Broadphase& engine);

 private:
  std::vector<Local> removed_;
  std::vector<Local> inserted_;
  std::vector<Aabb> inserted_boxes_;
  std::vector<BodyFilter> inserted_filters_;
  std::vector<Local> filtered_;
  std::vector<BodyFilter> filters_;
  std::vector<Local> moved_;
  std::vector<Aabb> moved_boxes_;
};

}  // namespace cellsweep::ranks
