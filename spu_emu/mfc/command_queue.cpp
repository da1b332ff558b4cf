#include "mfc/command_queue.h"

#include <utility>

#include "mfc/fault.h"
#include "mfc/format.h"
#include "mfc/watch.h"

namespace spu_emu {

CommandQueue::CommandQueue(LocalStoreView& store, const QueueSetup& setup)
    : issuer_(setup.issuer),
      mode_(setup.mode),
      depth_(setup.issuer == Issuer::proxy ? kProxyQueueDepth : kSpuQueueDepth),
      events_(setup.events),
      log_(setup.log),
      transfers_(store, counters_),
      store_(&store),
      random_(setup.seed) {
  queue_.reserve(depth_);
}

TraceTime CommandQueue::trace_time() const {
  return log_ == nullptr ? TraceTime{} : std::chrono::steady_clock::now();
}

void CommandQueue::report(const Command& command, std::uint64_t bytes, TraceTime issued, TraceTime begin) {
  if (log_ != nullptr) log_->transfer(command, bytes, issued, begin);
}

void CommandQueue::count(const Command& command) {
  if (is_get(command.opcode)) counters_.gets.add(1);
  if (is_store(command.opcode) || is_line_store(command.opcode)) counters_.puts.add(1);
}

void CommandQueue::issue(const Command& command) {
  if (mode_ == DmaMode::unchecked && queue_.empty() && is_simple_transfer(command.opcode)) {
    return issue_unchecked(command);
  }
  std::byte* host = nullptr;
  if (mode_ != DmaMode::unchecked) host = check_command(command, issuer_, *store_);
  if (!late() && queue_.empty() && !is_list(command.opcode)) return perform_now(command, host);
  make_room(command);
  Pending pending = prepare(command);
  if (late()) {
    settle_overlaps(pending);
    watch(pending);
  }
  queue_.push_back(std::move(pending));
  if (!late()) drain();
}

void CommandQueue::issue_unchecked(const Command& command) {
  const TraceTime begin = trace_time();
  count(command);
  move_piece(command, make_piece(command, command.ls, command.ea, command.size));
  report(command, command.size, begin, begin);
}

/// `host`: where the LS side is, found by the checks; plain transfers come here checked only.
void CommandQueue::perform_now(const Command& command, std::byte* host) {
  const TraceTime begin = trace_time();
  count(command);
  if (is_simple_transfer(command.opcode)) {
    move_piece(command, {host, command.ls, command.size, command.ea});
  } else {
    move_other(command);
  }
  report(command, is_simple_transfer(command.opcode) ? command.size : 0, begin, begin);
}

void CommandQueue::move_piece(const Command& command, const Piece& piece) {
  if (piece.size == 0) return;
  if (is_get(command.opcode)) {
    transfers_.get(command, piece);
  } else {
    transfers_.put(command, piece);
  }
}

/// What moves no plain bytes between local store and memory.
void CommandQueue::move_other(const Command& command) {
  if (is_line_store(command.opcode)) transfers_.put_line(command);
  if (command.opcode == MFC_SDCRZ_CMD) transfers_.zero_lines(command.ea, command.size);
}

void CommandQueue::make_room(const Command& command) {
  if (free_slots() != 0) return;
  counters_.queue_stalls.add(1);
  if (!land_first([](const Pending&) { return true; })) {
    throw Fault(Rule::deadlock, "the queue is full of commands behind a stalled list", command);
  }
}

Piece CommandQueue::make_piece(const Command& command, std::uint32_t ls, std::uint64_t ea,
                               std::uint32_t size) {
  if (mode_ != DmaMode::unchecked) {
    std::byte* host = check_transfer(command, ls, ea, size, *store_);
    // For real SPU code the check before has asked already.
    if (late() && !store_->has_real_code()) check_mapped(command, ea, size);
    return {host, ls, size, ea};
  }
  std::byte* host = store_->at(ls, size);
  if (host == nullptr) throw Fault(Rule::local_store_range, store_->why_not(ls, size), command);
  check_words(command, ls, ea, size, *store_);
  return {host, ls, size, ea};
}

CommandQueue::Pending CommandQueue::prepare(const Command& command) {
  Pending pending;
  pending.command = command;
  pending.id = next_id_++;
  pending.issued = trace_time();
  pending.next_ls = command.ls;
  if (is_list(command.opcode)) {
    collect_segment(pending);
  } else if (is_simple_transfer(command.opcode)) {
    pending.pieces.push_back(make_piece(command, command.ls, command.ea, command.size));
  } else if (is_line_store(command.opcode)) {
    const std::uint32_t ls = command.ls & ~(kLineSize - 1);
    pending.pieces.push_back({store_->at(ls, kLineSize), ls, kLineSize, command.ea});
  }
  return pending;
}

/// The transfers of a list up to and including its next element that stalls.
void CommandQueue::collect_segment(Pending& pending) {
  const auto list = static_cast<std::uint32_t>(pending.command.ea);
  const std::uint32_t count = pending.command.size / 8;
  pending.pieces.clear();
  pending.elements.clear();
  while (pending.next_element < count) {
    const ListElement element = read_list_element(*store_, list, pending.next_element++);
    pending.elements.push_back(element);
    collect_element(pending, element);
    if (element.notify()) return;
  }
}

void CommandQueue::collect_element(Pending& pending, const ListElement& element) {
  const Command& list = pending.command;
  Command named = list;
  named.ls = element_ls(pending.next_ls, element);
  named.ea = (list.ea & ~std::uint64_t{0xffffffffU}) | element.ea_low;
  named.size = element.size();
  if (mode_ != DmaMode::unchecked && std::uint64_t{element.ea_low} + named.size > (std::uint64_t{1} << 32U)) {
    throw Fault(Rule::list_crosses_4_gb,
                format("element %u crosses a 4 GB boundary", pending.next_element - 1), named);
  }
  pending.pieces.push_back(make_piece(named, named.ls, named.ea, named.size));
  pending.next_ls = next_element_ls(pending.next_ls, element);
}

/// A command issued before `pending` that is in flight on local store bytes that one of the two writes.
const CommandQueue::Pending* CommandQueue::find_overlap(const Pending& pending) const {
  for (const Pending& earlier : queue_) {
    if (earlier.id >= pending.id) break;
    if (!is_get(earlier.command.opcode) && !is_get(pending.command.opcode)) continue;
    for (const Piece& one : earlier.pieces) {
      for (const Piece& other : pending.pieces) {
        if (overlap(one, other)) return &earlier;
      }
    }
  }
  return nullptr;
}

/// Commands on the same local store bytes must be ordered; then the earlier one lands now, before bytes are
/// poisoned.
void CommandQueue::settle_overlaps(const Pending& pending) {
  while (const Pending* earlier = find_overlap(pending)) {
    if (!must_precede(earlier->command, pending.command)) {
      throw Fault(
          Rule::in_flight_overlap,
          format("a %s of tag %u on the same local store bytes is in flight and no fence or barrier orders "
                 "the two",
                 command_name(earlier->command.opcode), earlier->command.tag),
          pending.command);
    }
    const std::uint64_t id = earlier->id;
    if (!land_first([id](const Pending& other) { return other.id == id; })) {
      throw Fault(Rule::deadlock, "the command waits for a stalled list on the same bytes", pending.command);
    }
  }
}

std::vector<QueuedCommand> CommandQueue::commands() const {
  std::vector<QueuedCommand> all;
  for (const Pending& pending : queue_) {
    const std::uint32_t elements = is_list(pending.command.opcode) ? pending.command.size / 8 : 0;
    all.push_back({pending.command, pending.next_element, elements, pending.stalled});
  }
  return all;
}

void CommandQueue::watch(Pending& pending) {
  pending.watched = true;
  if (is_get(pending.command.opcode)) {
    poison(pending.pieces);
    // Real SPU code may touch them: its loads and stores are an interpreter's, which must not die of it.
    if (store_->word_order() == WordOrder::same) forbid_access(pending.pieces);
    for (const Piece& piece : pending.pieces) store_->note_written(piece.ls, piece.size);
  } else {
    pending.source = snapshot(pending.pieces);
  }
}

/// Throws Fault if the program touched what it must not before the landing.
void CommandQueue::end_watch(Pending& pending) {
  if (!pending.watched) return;
  pending.watched = false;
  const Command& command = pending.command;
  if (is_get(command.opcode)) {
    if (!end_poison(pending.pieces)) {
      throw Fault(Rule::in_flight_write, "the program wrote to the destination before waiting for the tag",
                  command);
    }
  } else if (snapshot(pending.pieces) != pending.source) {
    throw Fault(Rule::in_flight_source, "the program changed the source before waiting for the tag", command);
  }
  const auto first = pending.next_element - static_cast<std::uint32_t>(pending.elements.size());
  for (std::uint32_t i = 0; i < pending.elements.size(); ++i) {
    if (read_list_element(*store_, static_cast<std::uint32_t>(command.ea), first + i) !=
        pending.elements[i]) {
      throw Fault(Rule::in_flight_list, format("element %u changed before the list was done", first + i),
                  command);
    }
  }
}

}  // namespace spu_emu
