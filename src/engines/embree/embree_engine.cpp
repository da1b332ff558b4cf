#include "engines/embree/embree_engine.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "cellsweep/engine/phase_timer.h"

namespace cellsweep::embree {

Capacity EmbreeEngine::capacity() const {
  return {std::numeric_limits<std::uint32_t>::max() - 1, "", "Embree numbers boxes with 32 bits"};
}

void EmbreeEngine::apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  boxes_.resize(bodies().slot_count(), no_box());
  apply_move(slots, boxes);
}

void EmbreeEngine::apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < slots.size(); ++i) boxes_[slots[i]] = boxes[i];
  changed_ = changed_ || !slots.empty();
}

void EmbreeEngine::apply_remove(std::span<const Slot> slots) {
  for (const Slot slot : slots) boxes_[slot] = no_box();
  changed_ = changed_ || !slots.empty();
}

Result<PairChanges> EmbreeEngine::update() {
  PhaseTimer timer(statistics_.phases);
  slot_pairs_.clear();
  const bool any_pair = changed_ && size() > 1;
  if (any_pair) collider_.build(boxes_);
  builds_ += any_pair ? 1 : 0;
  timer.lap("build tree");
  if (any_pair) collider_.find_pairs(slot_pairs_);
  timer.lap("collide");
  PairChanges changes;
  if (changed_) {
    list_pairs();
    changes = compare_with_earlier();
  }
  changed_ = false;
  timer.lap("collect changes");
  ++statistics_.updates;
  statistics_.counters = {{"trees built", builds_}, {"candidates", collider_.candidates()}};
  return changes;
}

// Ascending, for what Embree's threads found comes in any order.
void EmbreeEngine::list_pairs() {
  earlier_.swap(pairs_);
  pairs_.clear();
  pairs_.reserve(slot_pairs_.size());
  for (const SlotPair& pair : slot_pairs_) {
    pairs_.push_back(make_pair_of(bodies().id(pair.first), bodies().id(pair.second)));
  }
  std::sort(pairs_.begin(), pairs_.end());
}

PairChanges EmbreeEngine::compare_with_earlier() {
  began_.clear();
  ended_.clear();
  std::set_difference(pairs_.begin(), pairs_.end(), earlier_.begin(), earlier_.end(),
                      std::back_inserter(began_));
  std::set_difference(earlier_.begin(), earlier_.end(), pairs_.begin(), pairs_.end(),
                      std::back_inserter(ended_));
  return {began_, ended_};
}

}  // namespace cellsweep::embree

namespace cellsweep {

Result<std::unique_ptr<Broadphase>> make_embree(const EngineOptions& options) {
  return std::unique_ptr<Broadphase>(std::make_unique<embree::EmbreeEngine>(options));
}

}  // namespace cellsweep
