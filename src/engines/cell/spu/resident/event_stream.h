/// @file
/// Pairs on their way to main memory: two pieces take turns, one is filled while the other is sent (C13).
#pragma once

#include "engines/cell/resident_wire.h"
#include "engines/cell/spu/common/dma.h"

namespace cellsweep::cell {

/// Sends any number of events to consecutive addresses. Uses DMA tags 0 and 1.
class EventStream {
 public:
  /// `pieces` is room for two pieces of kResidentEventChunk words.
  EventStream(unsigned int* pieces, unsigned long long ea) : pieces_(pieces), ea_(ea) {}

  void append(unsigned int event) {
    piece()[filled_++] = event;
    if (filled_ == kResidentEventChunk) send_piece();
  }

  /// Sends what is left and waits until all has arrived; returns how many events there were.
  unsigned int finish() {
    const unsigned int last = filled_;
    if (last != 0) send_piece();
    wait_for_tags(3);
    return last == 0 ? sent_ : sent_ - kResidentEventChunk + last;
  }

 private:
  unsigned int* piece() const { return pieces_ + turn_ * kResidentEventChunk; }

  void send_piece() {
    put_all(piece(), ea_ + 4ULL * sent_, round_up(4 * filled_, 16), turn_);
    sent_ += kResidentEventChunk;
    filled_ = 0;
    turn_ ^= 1U;
    wait_for_tag(turn_);
  }

  unsigned int* pieces_;
  unsigned long long ea_;
  unsigned int sent_ = 0;
  unsigned int filled_ = 0;
  unsigned int turn_ = 0;
};

}  // namespace cellsweep::cell
