#include "isa/timing/mfc_clock.h"

#include <algorithm>

#include "isa/encoding/instruction_word.h"
#include "mfc/spe_directory.h"
#include "spu_emu/channel_numbers.h"
#include "spu_emu/dma_mode.h"

namespace spu_emu::isa {

namespace {

constexpr std::size_t kQueueDepth = 16;

bool is_atomic(std::uint32_t opcode) {
  return opcode == MFC_GETLLAR_CMD || opcode == MFC_PUTLLC_CMD || opcode == MFC_PUTLLUC_CMD;
}

/// Of another local store or a problem state area. The lists' elements are taken for main memory.
bool is_local(const Command& command) {
  bool local = false;
  if (is_list(command.opcode) || !SpeDirectory::may_be_window(command.ea)) return false;
  SpeDirectory::instance().with_window(command.ea,
                                       [&](const SpeWindow* window) { local = window != nullptr; });
  return local;
}

}  // namespace

std::uint64_t MfcClock::write(std::uint32_t channel, std::uint32_t value, std::uint64_t now) {
  switch (channel) {
    case MFC_EAH:
      next_.ea = (next_.ea & 0xffffffffU) | (std::uint64_t{value} << 32U);
      break;
    case MFC_EAL:
      next_.ea = (next_.ea & ~std::uint64_t{0xffffffffU}) | value;
      break;
    case MFC_Size:
      next_.size = value & 0xffffU;
      break;
    case MFC_TagID:
      next_.tag = value & 31U;
      break;
    case MFC_Cmd:
      next_.opcode = value & 0xffU;
      return issue(next_, now);
    case MFC_WrTagMask:
      tag_mask_ = value;
      break;
    case MFC_WrTagUpdate:
      tag_update_ = value;
      break;
    default:
      break;
  }
  return now;
}

/// A look at the tags without a wait takes as long as until those were done that it reports: the emulated MFC
/// may be ahead of this clock.
std::uint64_t MfcClock::read(std::uint32_t channel, std::uint32_t value, std::uint64_t now) const {
  if (channel == MFC_RdAtomicStat) return std::max(now, atomic_done_);
  if (channel != MFC_RdTagStat) return now;
  if (tag_update_ == MFC_TAG_UPDATE_ANY) return std::max(now, earliest_done(tag_mask_));
  return std::max(now, latest_done(tag_update_ == MFC_TAG_UPDATE_ALL ? tag_mask_ : value));
}

bool MfcClock::uses_port(std::uint64_t cycle) const {
  if (cycle >= port_free_) return false;
  return std::any_of(moves_.begin(), moves_.end(), [&](const Move& move) {
    return cycle >= move.port_begin && cycle < move.port_end &&
           (cycle - move.port_begin) % move.port_step == 0;
  });
}

void MfcClock::restart() {
  moves_.clear();
  port_free_ = 0;
  bus_free_ = 0;
  atomic_done_ = 0;
}

std::uint64_t MfcClock::issue(const Command& command, std::uint64_t now) {
  now = wait_for_queue(now);
  std::erase_if(moves_, [now](const Move& move) { return move.done <= now; });
  const Load load = load_of(command);
  add_move(command, load, now);
  if (is_atomic(command.opcode)) atomic_done_ = moves_.back().done;
  bytes_ += load.bytes;
  ++commands_;
  return now;
}

std::uint64_t MfcClock::wait_for_queue(std::uint64_t now) const {
  std::vector<std::uint64_t> busy;
  for (const Move& move : moves_) {
    if (move.done > now) busy.push_back(move.done);
  }
  if (busy.size() < kQueueDepth) return now;
  // Free when all but one less than the queue holds are done.
  std::sort(busy.begin(), busy.end());
  return busy[busy.size() - kQueueDepth];
}

void MfcClock::add_move(const Command& command, const Load& load, std::uint64_t now) {
  const bool local = is_local(command);
  const double shared = parameters_.memory_bytes_per_cycle / parameters_.sharing_spes;
  const double rate = local ? parameters_.port_bytes_per_cycle  //
                            : std::min(parameters_.port_bytes_per_cycle, shared);
  const std::uint32_t latency = load.on_bus == 0 ? 0
                                : local          ? parameters_.local_store_latency
                                                 : parameters_.memory_latency;
  std::uint64_t begin = std::max(now + parameters_.dma_start, bus_free_);
  for (const Move& move : moves_) {
    if (must_precede(move.command, command)) begin = std::max(begin, move.done);
  }
  const auto moving = static_cast<std::uint64_t>(static_cast<double>(load.on_bus) / rate);
  const std::uint64_t elements = load.elements == 0 ? 0 : load.elements - 1;
  bus_free_ = begin + moving + elements * parameters_.dma_element;
  const std::uint64_t lines = std::max<std::uint64_t>(1, load.on_bus / parameters_.bus_line);
  const std::uint64_t port_begin = begin + (is_get(command.opcode) ? latency : 0);
  moves_.push_back({command, bus_free_ + latency, port_begin, port_begin + moving,
                    std::max<std::uint64_t>(1, moving / lines)});
  port_free_ = std::max(port_free_, port_begin + moving);
}

MfcClock::Load MfcClock::load_of(const Command& command) const {
  Load load;
  if (is_list(command.opcode)) {
    const auto list = static_cast<std::uint32_t>(command.ea);
    for (std::uint32_t at = 0; at + 8 <= command.size; at += 8) {
      add_element(load, fetch(local_store_, (list + at) & kCodeMask) & 0x7fffU);
    }
  } else if (is_atomic(command.opcode) || command.opcode == MFC_PUTQLLUC_CMD) {
    add_element(load, kLineSize);
  } else if (is_get(command.opcode) || is_store(command.opcode)) {
    add_element(load, command.size);
  }
  return load;
}

void MfcClock::add_element(Load& load, std::uint32_t bytes) const {
  load.bytes += bytes;
  load.on_bus +=
      (bytes + std::uint64_t{parameters_.bus_line} - 1) / parameters_.bus_line * parameters_.bus_line;
  ++load.elements;
}

std::uint64_t MfcClock::latest_done(std::uint32_t tags) const {
  std::uint64_t latest = 0;
  for (const Move& move : moves_) {
    if ((tags >> move.command.tag & 1U) != 0) latest = std::max(latest, move.done);
  }
  return latest;
}

/// When the first of the tags has no command left.
std::uint64_t MfcClock::earliest_done(std::uint32_t tags) const {
  std::uint64_t earliest = ~std::uint64_t{0};
  for (std::uint32_t tag = 0; tag < 32; ++tag) {
    if ((tags >> tag & 1U) != 0) earliest = std::min(earliest, latest_done(1U << tag));
  }
  return tags == 0 ? 0 : earliest;
}

}  // namespace spu_emu::isa
