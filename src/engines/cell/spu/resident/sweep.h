/// @file
/// One body against those that its axis does not keep apart from it: where the three axes are combined.
#pragma once

#include "engines/cell/spu/resident/event_stream.h"
#include "engines/cell/spu/resident/sorted_axis.h"

namespace cellsweep::cell {

/// Finds what changed bodies overlap in the state that a sorted axis shows, and sends an event for each pair
/// that does not overlap in the other state, before or after the same order. One object a state.
class Sweep {
 public:
  /// `elsewhere` holds the boxes of marked bodies in the other state, by number of record; unmarked bodies
  /// have the same box in both. Null: marked bodies do not exist there. `flag` goes into each event.
  Sweep(const SortedAxis& axis, const BodyBox* elsewhere, unsigned int flag, EventStream& events)
      : axis_(axis), elsewhere_(elsewhere), flag_(flag), events_(events) {}

  /// All pairs of the marked body with the box `own` and the number `record`; a pair of two marked bodies is
  /// sent by the one of the lower number. Quickest when bodies come in ascending order.
  void sweep(const BodyBox& own, unsigned int record);

 private:
  void judge(const BoxBlock& block, unsigned int hits, const BodyBox& own, unsigned int record);

  const SortedAxis& axis_;
  const BodyBox* elsewhere_;
  unsigned int flag_;
  EventStream& events_;
  unsigned int first_ = 0;  // the block at which the last sweep began
};

}  // namespace cellsweep::cell
