#include "broad_phase.h"

#include <algorithm>
#include <iterator>

namespace physx_front {
namespace {

cellsweep::Aabb grown(cellsweep::Aabb box, float distance) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] -= distance;
    box.max[axis] += distance;
  }
  return box;
}

}  // namespace

bool BroadPhase::noted(const cellsweep::Status& status) {
  error_ = status.message;
  return status.ok();
}

void BroadPhase::gather(std::span<const Index> indices, const UpdateData& data) {
  boxes_.clear();
  for (const Index index : indices) {
    boxes_.push_back(data.distances.empty() ? data.bounds[index]
                                            : grown(data.bounds[index], data.distances[index]));
  }
}

void BroadPhase::note_groups(const UpdateData& data) {
  filters_.clear();
  for (const Index index : data.created) {
    if (groups_.size() <= index) groups_.resize(index + std::size_t{1});
    groups_[index] = data.groups[index];
    filters_.push_back({.is_static = groups_[index] == kStatic});
  }
}

// There are as many groups as actors, and a filter's mask has 32 bits: who is of one group is looked at here.
std::span<const cellsweep::Pair> BroadPhase::of_two_groups(std::span<const cellsweep::Pair> pairs,
                                                           std::vector<cellsweep::Pair>& kept) const {
  kept.clear();
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(kept),
               [&](cellsweep::Pair pair) { return groups_[pair.a] != groups_[pair.b]; });
  return kept;
}

bool BroadPhase::update(const UpdateData& data) {
  if (!noted(broadphase_.remove(data.removed))) return false;
  gather(data.created, data);
  note_groups(data);
  if (!noted(broadphase_.insert(data.created, boxes_, filters_))) return false;
  gather(data.updated, data);
  if (!noted(broadphase_.move(data.updated, boxes_))) return false;
  const auto changes = broadphase_.update();
  if (!noted(changes.status())) return false;
  results_ = {of_two_groups(changes->began, created_), of_two_groups(changes->ended, deleted_)};
  return true;
}

}  // namespace physx_front
