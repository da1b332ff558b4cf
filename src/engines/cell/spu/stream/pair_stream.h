/// @file
/// The pairs that an SPU finds, on their way to main memory in chunks, two of which take turns.
#pragma once

#include "engines/cell/spu/common/dma.h"
#include "engines/cell/stream_wire.h"

namespace cellsweep::cell {

class PairStream {
 public:
  /// Uses the tags `first_tag` and the one after it. `chunks` holds two times kStreamPairs pairs.
  PairStream(std::uint32_t* chunks, const StreamJob& job, unsigned int first_tag)
      : chunks_(chunks), ea_(ea_of(job.pairs)), room_(job.room), first_tag_(first_tag) {}

  /// True when as many pairs as a box can have in a block can be added.
  bool has_room() {
    if (count_ + kStreamBlock <= kStreamPairs) return true;
    flush();
    return sent_ + kStreamPairs <= room_;
  }

  void add(std::uint32_t slot, std::uint32_t other) {
    std::uint32_t* pair = chunk() + 2 * count_++;
    pair[0] = slot;
    pair[1] = other;
  }

  /// Sends what there is, and waits until the other chunk is free again.
  void flush() {
    if (count_ % 2 != 0) add(kNoStreamPair, kNoStreamPair);
    put_all(chunk(), ea_ + 8ULL * sent_, 8 * count_, first_tag_ + turn_);
    sent_ += count_;
    count_ = 0;
    turn_ ^= 1U;
    wait_for_tag(first_tag_ + turn_);
  }

  std::uint32_t sent() const { return sent_; }

 private:
  std::uint32_t* chunk() const { return chunks_ + turn_ * 2 * kStreamPairs; }

  std::uint32_t* chunks_;
  unsigned long long ea_;
  std::uint32_t room_;
  unsigned int first_tag_;
  unsigned int turn_ = 0;
  std::uint32_t count_ = 0;  // in the chunk
  std::uint32_t sent_ = 0;
};

}  // namespace cellsweep::cell
