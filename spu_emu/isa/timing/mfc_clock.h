/// @file
/// When DMA commands would be done on a Cell: the MFC of one SPE, in cycles of its SPU.
#ifndef SPU_EMU_ISA_TIMING_MFC_CLOCK_H
#define SPU_EMU_ISA_TIMING_MFC_CLOCK_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mfc/command.h"
#include "spu_emu/cycles.h"

namespace spu_emu::isa {

/// Follows the channel accesses of one SPU. Commands share the bus: each begins after the one before has
/// moved its bytes, and is complete a latency after its last byte left; so latencies overlap and bandwidth
/// does not. Fences and barriers wait for completion.
class MfcClock {
 public:
  /// `local_store` is where lists are read from.
  MfcClock(const CycleParameters& parameters, const std::byte* local_store)
      : parameters_(parameters), local_store_(local_store) {}

  /// A channel is written at cycle `now`; gives the cycle at which the write goes through: later if the
  /// command queue is full.
  std::uint64_t write(std::uint32_t channel, std::uint32_t value, std::uint64_t now);

  /// The cycle at which a read of `channel` at `now`, whose result was `value`, returns.
  std::uint64_t read(std::uint32_t channel, std::uint32_t value, std::uint64_t now) const;

  /// True if DMA moves a line into or out of the local store in this cycle.
  bool uses_port(std::uint64_t cycle) const;

  /// A program begins: nothing is in flight.
  void restart();

  /// Bytes moved and commands issued so far.
  std::uint64_t bytes() const { return bytes_; }
  std::uint64_t commands() const { return commands_; }

 private:
  struct Move {
    Command command;
    std::uint64_t done;        // tag complete
    std::uint64_t port_begin;  // its bytes pass the local store's port from here
    std::uint64_t port_end;
    std::uint64_t port_step;  // a line every so many cycles
  };
  /// What a command moves: bytes, and bytes as the bus counts them, in whole lines for each element.
  struct Load {
    std::uint64_t bytes = 0;
    std::uint64_t on_bus = 0;
    std::uint32_t elements = 0;
  };

  std::uint64_t issue(const Command& command, std::uint64_t now);
  std::uint64_t wait_for_queue(std::uint64_t now) const;
  void add_move(const Command& command, const Load& load, std::uint64_t now);
  Load load_of(const Command& command) const;
  void add_element(Load& load, std::uint32_t bytes) const;
  std::uint64_t latest_done(std::uint32_t tags) const;
  std::uint64_t earliest_done(std::uint32_t tags) const;

  CycleParameters parameters_;
  const std::byte* local_store_;
  std::vector<Move> moves_;  // that were not complete at the last command
  Command next_;             // as far as its channels have been written
  std::uint64_t bus_free_ = 0;
  std::uint64_t port_free_ = 0;
  std::uint64_t atomic_done_ = 0;
  std::uint64_t bytes_ = 0;
  std::uint64_t commands_ = 0;
  std::uint32_t tag_mask_ = 0;
  std::uint32_t tag_update_ = 0;
};

}  // namespace spu_emu::isa

#endif
