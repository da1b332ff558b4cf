#include "mfc/atomic_unit.h"

#include <utility>

namespace spu_emu {

void AtomicUnit::execute(const Command& command) {
  counters_.atomics.add(1);
  ReservationTable& table = ReservationTable::instance();
  std::byte* line = transfers_.line_address(command);
  if (command.opcode == MFC_GETLLAR_CMD) {
    LineWords words{};
    table.load(*this, line, words);
    transfers_.write_store_line(command.ls, words);
    status_ = MFC_GETLLAR_STATUS;
  } else if (command.opcode == MFC_PUTLLC_CMD) {
    const bool stored = table.store_conditional(*this, line, transfers_.read_store_line(command.ls));
    if (!stored) counters_.lost_reservations.add(1);
    status_ = stored ? 0U : static_cast<std::uint32_t>(MFC_PUTLLC_STATUS);
  } else {
    transfers_.put_line(command);
    status_ = MFC_PUTLLUC_STATUS;
  }
}

std::optional<std::uint32_t> AtomicUnit::take_status() {
  return std::exchange(status_, std::nullopt);
}

void AtomicUnit::poll_reservation() {
  if (!ReservationTable::instance().changed(*this)) return;
  ReservationTable::instance().drop(*this);
  lost();
}

void AtomicUnit::lost() {
  events_.raise(MFC_LLR_LOST_EVENT);
}

}  // namespace spu_emu
