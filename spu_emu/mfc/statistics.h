/// @file
/// What one SPE did, counted.
#ifndef SPU_EMU_MFC_STATISTICS_H
#define SPU_EMU_MFC_STATISTICS_H

#include <atomic>
#include <cstdint>

namespace spu_emu {

/// A number that one thread at a time adds to and any thread may read.
class Counter {
 public:
  void add(std::uint64_t amount) {
    value_.store(value_.load(std::memory_order_relaxed) + amount, std::memory_order_relaxed);
  }
  std::uint64_t value() const { return value_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::uint64_t> value_{0};
};

/// Counts of one command queue. Bytes and commands are counted when they move, stalls when the queue is full.
struct QueueCounters {
  Counter gets;
  Counter puts;
  Counter bytes_in;
  Counter bytes_out;
  Counter list_elements;
  Counter queue_stalls;
};

/// Counts of an SPU's channels.
struct ChannelCounters {
  Counter tag_waits;
  Counter mailbox_waits;
  Counter signal_waits;
  Counter event_waits;
  Counter atomics;
  Counter lost_reservations;
};

}  // namespace spu_emu

#endif
