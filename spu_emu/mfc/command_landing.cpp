// The half of CommandQueue that lands commands: which comes next, and what becomes of it.
#include <algorithm>
#include <array>
#include <utility>

#include "mfc/command_queue.h"
#include "mfc/fault.h"
#include "mfc/format.h"
#include "mfc/watch.h"

namespace spu_emu {

namespace {
std::uint32_t tag_bit(const Command& command) {
  return 1U << (command.tag & 31U);
}
}  // namespace

bool CommandQueue::can_land(std::size_t index) const {
  if (queue_[index].stalled) return false;
  return std::none_of(
      queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(index),
      [&](const Pending& earlier) { return must_precede(earlier.command, queue_[index].command); });
}

/// A command that can land now and is wanted or must go before a wanted one: a random one in late mode, else
/// the first.
std::optional<std::size_t> CommandQueue::choose(const Wanted& wanted) {
  std::array<bool, kSpuQueueDepth> needed{};
  std::array<std::size_t, kSpuQueueDepth> candidates{};
  std::size_t found = 0;
  for (std::size_t i = queue_.size(); i-- > 0;) {
    needed[i] = needed[i] || wanted(queue_[i]);
    if (!needed[i]) continue;
    for (std::size_t j = 0; j < i; ++j) {
      needed[j] = needed[j] || must_precede(queue_[j].command, queue_[i].command);
    }
    if (can_land(i)) candidates[found++] = i;
  }
  if (found == 0) return std::nullopt;
  return late() ? candidates[random_.below(found)] : candidates[found - 1];
}

bool CommandQueue::land_first(const Wanted& wanted) {
  const auto index = choose(wanted);
  if (index) land(*index);
  return index.has_value();
}

void CommandQueue::land_wanted(const Wanted& wanted) {
  while (land_first(wanted)) {
  }
}

void CommandQueue::land(std::size_t index) {
  Pending pending = std::move(queue_[index]);
  const bool was_full = free_slots() == 0;
  queue_.erase(queue_.begin() + static_cast<std::ptrdiff_t>(index));
  end_watch(pending);
  const TraceTime begin = trace_time();
  move(pending);
  report(pending.command, bytes_of(pending), pending.issued, begin);
  if (!pending.elements.empty() && pending.elements.back().notify()) return stall(std::move(pending), index);
  count(pending.command);
  if (was_full && events_ != nullptr) events_->raise_own(MFC_COMMAND_QUEUE_AVAILABLE_EVENT);
}

std::uint64_t CommandQueue::bytes_of(const Pending& pending) {
  if (!is_get(pending.command.opcode) && !is_store(pending.command.opcode)) return 0;
  std::uint64_t bytes = 0;
  for (const Piece& piece : pending.pieces) bytes += piece.size;
  return bytes;
}

void CommandQueue::move(const Pending& pending) {
  const Command& command = pending.command;
  if (!is_get(command.opcode) && !is_store(command.opcode)) return move_other(command);
  for (const Piece& piece : pending.pieces) move_piece(command, piece);
  counters_.list_elements.add(pending.elements.size());
}

void CommandQueue::stall(Pending pending, std::size_t index) {
  pending.stalled = true;
  pending.pieces.clear();
  pending.elements.clear();
  const std::uint32_t bit = tag_bit(pending.command);
  queue_.insert(queue_.begin() + static_cast<std::ptrdiff_t>(index), std::move(pending));
  stall_status_ |= bit;
  if (events_ != nullptr) events_->raise_own(MFC_LIST_STALL_NOTIFY_EVENT);
}

std::uint32_t CommandQueue::take_stall_status() {
  return std::exchange(stall_status_, 0U);
}

void CommandQueue::acknowledge_stall(std::uint32_t tag, SourceLine where) {
  std::vector<std::uint64_t> stalled;
  for (const Pending& pending : queue_) {
    if (pending.stalled && pending.command.tag == tag) stalled.push_back(pending.id);
  }
  if (stalled.empty()) {
    throw Fault(Rule::list_acknowledge, format("no list of tag %u has stalled", tag),
                Command{MFC_GETL_CMD, tag, 0, 0, 0, where});
  }
  for (const std::uint64_t id : stalled) resume(id);
  if (!late()) drain();
}

std::size_t CommandQueue::index_of(std::uint64_t id) const {
  const auto found =
      std::find_if(queue_.begin(), queue_.end(), [id](const Pending& p) { return p.id == id; });
  return static_cast<std::size_t>(found - queue_.begin());
}

/// The list keeps its place in the queue, stalled, until its next transfers are known to be legal.
void CommandQueue::resume(std::uint64_t id) {
  Pending next = queue_[index_of(id)];
  next.stalled = false;
  collect_segment(next);
  if (late()) {
    settle_overlaps(next);
    watch(next);
  }
  queue_[index_of(id)] = std::move(next);
}

std::uint32_t CommandQueue::pending_tags() const {
  std::uint32_t tags = 0;
  for (const Pending& pending : queue_) tags |= tag_bit(pending.command);
  return tags;
}

void CommandQueue::land_tags(std::uint32_t tags) {
  if (queue_.empty()) return;
  land_wanted([tags](const Pending& pending) { return (tag_bit(pending.command) & tags) != 0; });
}

void CommandQueue::land_stores() {
  if (queue_.empty()) return;
  land_wanted([](const Pending& pending) {
    return is_store(pending.command.opcode) || is_line_store(pending.command.opcode);
  });
}

void CommandQueue::land_all() {
  land_wanted([](const Pending&) { return true; });
}

void CommandQueue::drain() {
  land_all();
}

bool CommandQueue::land_one(std::uint32_t tags) {
  return land_first([tags](const Pending& pending) { return (tag_bit(pending.command) & tags) != 0; });
}

void CommandQueue::land_stalling_lists() {
  land_wanted(
      [](const Pending& pending) { return !pending.elements.empty() && pending.elements.back().notify(); });
}

void CommandQueue::clear() {
  for (const Pending& pending : queue_) {
    if (pending.watched && is_get(pending.command.opcode)) end_poison(pending.pieces);
  }
  queue_.clear();
  stall_status_ = 0;
}

}  // namespace spu_emu
