/// @file
/// Boxes made from poses on the SPUs, an axis each (F3).
#pragma once

#include "engines/cell/resident_wire.h"
#include "engines/cell/spu/resident/pose_box.h"

namespace cellsweep::cell {

/// Streams poses through the local store: a piece is computed while the next one comes in and the one before
/// goes out. SPUs of the same axis take turns in the pieces. Uses DMA tags 3 and 4. Without poses in the job
/// it takes no local store.
class BoxMaker {
 public:
  explicit BoxMaker(const ResidentJob& job);

  /// Writes the intervals of so many bodies to main memory and waits until they are there.
  void enclose_all(unsigned int bodies);

 private:
  void fetch(unsigned int piece, unsigned int turn);
  void send(unsigned int piece, unsigned int turn);
  unsigned int blocks_of(unsigned int piece) const;

  unsigned long long poses_ea_;
  unsigned long long intervals_ea_;
  unsigned int axis_;
  unsigned int first_piece_;
  unsigned int piece_step_;
  unsigned int blocks_ = 0;
  PoseVectors* poses_ = nullptr;  // two pieces
  IntervalVectors* intervals_ = nullptr;
};

}  // namespace cellsweep::cell
