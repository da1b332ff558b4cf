/// @file
/// The MFC's atomic commands: executed at once, outside the queue, with their status channel.
#ifndef SPU_EMU_MFC_ATOMIC_UNIT_H
#define SPU_EMU_MFC_ATOMIC_UNIT_H

#include <optional>

#include "mfc/events.h"
#include "mfc/transfers.h"

namespace spu_emu {

/// getllar, putllc and putlluc of one SPE. Used by the SPU's own thread; reservations are taken away by any.
class AtomicUnit final : public Reservation {
 public:
  AtomicUnit(Transfers& transfers, Events& events, ChannelCounters& counters)
      : transfers_(transfers), events_(events), counters_(counters) {}
  ~AtomicUnit() override { ReservationTable::instance().drop(*this); }
  AtomicUnit(const AtomicUnit&) = delete;
  AtomicUnit& operator=(const AtomicUnit&) = delete;

  /// True for the opcodes that `execute` takes.
  static bool handles(std::uint32_t opcode) {
    return opcode == MFC_GETLLAR_CMD || opcode == MFC_PUTLLC_CMD || opcode == MFC_PUTLLUC_CMD;
  }
  /// Executes a checked command and sets the status.
  void execute(const Command& command);
  bool has_status() const { return status_.has_value(); }
  /// The status of the last command, once: MFC_PUTLLC_STATUS means that putllc did not store.
  std::optional<std::uint32_t> take_status();
  /// Raises the lost event if a thread that is no SPE changed the reserved line.
  void poll_reservation();

 private:
  void lost() override;

  Transfers& transfers_;
  Events& events_;
  ChannelCounters& counters_;
  std::optional<std::uint32_t> status_;
};

}  // namespace spu_emu

#endif
