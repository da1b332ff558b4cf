#include "app/ranks/own_bodies.h"

namespace cellsweep::app {

void OwnBodies::set(GlobalId id, bool mine) {
  if (id >= mine_.size()) mine_.resize(id + 1 + mine_.size() / 2);
  mine_[id] = mine;
}

void OwnBodies::adopt(std::span<const GlobalId> owned) {
  for (const GlobalId id : owned) set(id, true);
}

void OwnBodies::take_over(const RankChanges& changes) {
  for (const GlobalId id : ids_) set(id, true);  // the inserted, before some of them depart
  for (const Handover& departed : changes.departed) set(departed.id, false);
  for (const Handover& arrived : changes.arrived) set(arrived.id, true);
}

template <class IsChosen>
void OwnBodies::choose(const FrameSource& source, std::span<const BodyId> from, const IsChosen& is_chosen) {
  ids_.clear();
  boxes_.clear();
  filters_.clear();
  for (const BodyId id : from) {
    if (!is_chosen(id)) continue;
    ids_.push_back(id);
    boxes_.push_back(source.boxes()[id]);
    if (!source.filters().empty()) filters_.push_back(source.filters()[id]);
  }
}

Status OwnBodies::hand_over(const FrameSource& source, std::span<const BodyId> inserted,
                            DistributedBroadphase& world) {
  if (Status status = remove(source, world); !status.ok()) return status;
  if (Status status = move(source, world); !status.ok()) return status;
  return insert(source, inserted, world);
}

Status OwnBodies::insert(const FrameSource& source, std::span<const BodyId> inserted,
                         DistributedBroadphase& world) {
  choose(source, inserted,
         [&](BodyId id) { return static_cast<int>(id % static_cast<BodyId>(ranks_)) == rank_; });
  if (filters_.empty()) return world.insert(ids_, boxes_);
  return world.insert(ids_, boxes_, filters_);
}

Status OwnBodies::move(const FrameSource& source, DistributedBroadphase& world) {
  choose(source, source.moved(), [&](BodyId id) { return is_mine(id); });
  return world.move(ids_, boxes_);
}

Status OwnBodies::remove(const FrameSource& source, DistributedBroadphase& world) {
  ids_.clear();
  for (const BodyId id : source.removed()) {
    if (!is_mine(id)) continue;
    ids_.push_back(id);
    set(id, false);
  }
  return world.remove(ids_);
}

}  // namespace cellsweep::app
