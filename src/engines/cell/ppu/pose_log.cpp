#include "engines/cell/ppu/pose_log.h"

#include <algorithm>

namespace cellsweep::cell {
namespace {

void write_lane(PoseBlock& block, std::size_t lane, const BodyPose& pose) {
  for (std::size_t i = 0; i < 4; ++i) block.orientation[i][lane] = pose.orientation[i];
  for (std::size_t i = 0; i < 3; ++i) {
    block.half_extents[i][lane] = pose.half_extents[i];
    block.centre[i][lane] = pose.centre[i];
  }
}

}  // namespace

void PoseLog::set(Slot slot, const BodyPose& pose) {
  if (slot >= poses_.size()) {
    poses_.resize(slot + 1);
    state_.resize(slot + 1, State::none);
  }
  if (state_[slot] != State::none && poses_[slot] == pose) return;
  if (state_[slot] != State::pending) pending_.push_back(slot);
  state_[slot] = State::pending;
  poses_[slot] = pose;
}

void PoseLog::forget(Slot slot) {
  if (slot >= state_.size()) return;
  if (state_[slot] == State::pending) std::erase(pending_, slot);
  state_[slot] = State::none;
}

void PoseLog::pack(std::span<PoseBlock> blocks) const {
  const std::size_t filled = (pending_.size() + kLanes - 1) / kLanes * kLanes;
  for (std::size_t i = 0; i < filled; ++i)
    write_lane(blocks[i / kLanes], i % kLanes, i < pending_.size() ? poses_[pending_[i]] : BodyPose{});
}

void PoseLog::clear_pending() {
  for (const Slot slot : pending_) state_[slot] = State::known;
  pending_.clear();
}

}  // namespace cellsweep::cell
