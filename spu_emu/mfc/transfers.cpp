#include "mfc/transfers.h"

#include <algorithm>
#include <cstring>

#include "mfc/copy.h"
#include "mfc/fault.h"
#include "mfc/spe_directory.h"

namespace spu_emu {

namespace {
std::byte* memory_at(std::uint64_t ea) {
  return reinterpret_cast<std::byte*>(static_cast<std::uintptr_t>(ea));
}

WordOrder order_between(const LocalStoreView& one, const LocalStoreView& other) {
  return one.word_order() == other.word_order() ? WordOrder::same : WordOrder::swapped;
}

/// A 4-byte access to a problem state register; `to_local` reads it.
bool access_register(ProblemState& registers, std::uint32_t offset, const Piece& piece, WordOrder order,
                     bool to_local) {
  if (piece.size != sizeof(std::uint32_t)) return false;
  std::uint32_t value = 0;
  if (to_local && !registers.read_register(offset, value)) return false;
  auto* word = reinterpret_cast<std::byte*>(&value);
  copy_bytes(to_local ? piece.host : word, to_local ? word : piece.host, sizeof value, order);
  return to_local || registers.write_register(offset, value);
}
}  // namespace

/// True if the EA lies in an SPE's window and the move was made there.
bool Transfers::move_within_window(const Command& command, const Piece& piece, bool to_local) {
  bool moved = false;
  SpeDirectory::instance().with_window(piece.ea, [&](const SpeWindow* window) {
    if (window == nullptr) return;
    moved = true;
    const std::uint32_t offset = window_offset(piece.ea);
    if (offset >= kProblemStateOffset) {
      if (window->registers == nullptr || !access_register(*window->registers, offset - kProblemStateOffset,
                                                           piece, store_->word_order(), to_local)) {
        throw Fault(Rule::register_access, "no 4-byte register of a problem state area is there", command);
      }
      return;
    }
    std::byte* other = window->store->at(offset, piece.size);
    if (other == nullptr) {
      throw Fault(Rule::effective_address, "in the other SPE, " + window->store->why_not(offset, piece.size),
                  command);
    }
    copy_bytes(to_local ? piece.host : other, to_local ? other : piece.host, piece.size,
               order_between(*store_, *window->store));
    if (to_local) return;
    ReservationTable::instance().written(other, piece.size);
    window->store->note_written(offset, piece.size);
  });
  return moved;
}

void Transfers::get(const Command& command, const Piece& piece) {
  counters_.bytes_in.add(piece.size);
  if (!SpeDirectory::may_be_window(piece.ea) || !move_within_window(command, piece, true)) {
    copy_bytes(piece.host, memory_at(piece.ea), piece.size, store_->word_order());
  }
  store_->note_written(piece.ls, piece.size);
}

void Transfers::put(const Command& command, const Piece& piece) {
  counters_.bytes_out.add(piece.size);
  if (SpeDirectory::may_be_window(piece.ea) && move_within_window(command, piece, false)) return;
  copy_bytes(memory_at(piece.ea), piece.host, piece.size, store_->word_order());
  ReservationTable::instance().written(memory_at(piece.ea), piece.size);
}

void Transfers::zero_lines(std::uint64_t ea, std::uint32_t size) {
  const std::uint64_t end = ea + size;
  for (std::uint64_t line = ea & ~std::uint64_t{kLineSize - 1}; line < end; line += kLineSize) {
    ReservationTable::instance().store(memory_at(line), LineWords{});
  }
}

void Transfers::put_line(const Command& command) {
  counters_.bytes_out.add(kLineSize);
  ReservationTable::instance().store(line_address(command), read_store_line(command.ls));
}

std::byte* Transfers::line_address(const Command& command) {
  const std::uint64_t ea = command.ea & ~std::uint64_t{kLineSize - 1};
  std::byte* line = memory_at(ea);
  if (!SpeDirectory::may_be_window(ea)) return line;
  SpeDirectory::instance().with_window(ea, [&](const SpeWindow* window) {
    if (window != nullptr) line = window->store->at(window_offset(ea), kLineSize);
  });
  if (line == nullptr)
    throw Fault(Rule::effective_address, "no line of an SPE's local store is there", command);
  return line;
}

LineWords Transfers::read_store_line(std::uint32_t ls) {
  LineWords words{};
  copy_bytes(reinterpret_cast<std::byte*>(words.data()), store_->at(ls & ~(kLineSize - 1), kLineSize),
             kLineSize, store_->word_order());
  return words;
}

void Transfers::write_store_line(std::uint32_t ls, const LineWords& words) {
  copy_bytes(store_->at(ls & ~(kLineSize - 1), kLineSize), reinterpret_cast<const std::byte*>(words.data()),
             kLineSize, store_->word_order());
  store_->note_written(ls & ~(kLineSize - 1), kLineSize);
}

}  // namespace spu_emu
