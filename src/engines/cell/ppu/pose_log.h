/// @file
/// The poses of an engine's bodies, and which of them have no box yet (F3).
#pragma once

#include <span>
#include <vector>

#include "broadphase/body_table.h"
#include "cellsweep/pose.h"
#include "engines/cell/resident_wire.h"

namespace cellsweep::cell {

/// A body's latest pose by its slot. A pose that says nothing new is not listed again.
class PoseLog {
 public:
  void set(Slot slot, const BodyPose& pose);

  /// The body is gone or has a box from its caller.
  void forget(Slot slot);

  /// Slots whose pose is new since the last clear_pending(), each once.
  std::span<const Slot> pending() const { return pending_; }

  /// Writes the pending poses, in the order of pending(), into blocks; the last one is filled up.
  void pack(std::span<PoseBlock> blocks) const;

  void clear_pending();

 private:
  enum class State : std::uint8_t { none, known, pending };

  std::vector<BodyPose> poses_;  // by slot
  std::vector<State> state_;     // by slot
  std::vector<Slot> pending_;
};

}  // namespace cellsweep::cell
