/// @file
/// Moves the bytes of a command: between a local store and whatever its effective address means.
#ifndef SPU_EMU_MFC_TRANSFERS_H
#define SPU_EMU_MFC_TRANSFERS_H

#include "mfc/command.h"
#include "mfc/local_store.h"
#include "mfc/reservations.h"
#include "mfc/statistics.h"

namespace spu_emu {

/// One contiguous move; `host` is where LS address `ls` is in host memory. At most 16 KB.
struct Piece {
  std::byte* host = nullptr;
  std::uint32_t ls = 0;
  std::uint32_t size = 0;
  std::uint64_t ea = 0;
};

/// Has no state of its own but counters; each queue has one and uses it from one thread at a time.
class Transfers {
 public:
  Transfers(LocalStoreView& store, QueueCounters& counters) : store_(&store), counters_(counters) {}

  LocalStoreView& store() { return *store_; }
  void use_store(LocalStoreView& store) { store_ = &store; }
  QueueCounters& counters() { return counters_; }

  /// Main memory (or another SPE's local store or register, by the EA) to local store. `command` is for
  /// faults.
  void get(const Command& command, const Piece& piece);
  /// Local store to main memory; reservations of the lines written are lost.
  void put(const Command& command, const Piece& piece);
  /// Zeroes the lines that [ea, ea + size) touches: sdcrz.
  void zero_lines(std::uint64_t ea, std::uint32_t size);
  /// Unconditional store of 128 bytes: putlluc and putqlluc.
  void put_line(const Command& command);

  /// Host address of the line that an atomic command means, wherever it lies. Throws Fault.
  std::byte* line_address(const Command& command);
  /// The line's words as the local store has them at `ls`, in main memory's order, and back.
  LineWords read_store_line(std::uint32_t ls);
  void write_store_line(std::uint32_t ls, const LineWords& words);

 private:
  bool move_within_window(const Command& command, const Piece& piece, bool to_local);

  LocalStoreView* store_;
  QueueCounters& counters_;
};

}  // namespace spu_emu

#endif
