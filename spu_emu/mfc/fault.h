/// @file
/// A broken rule of the hardware: which one, by what command, where, and how libspe2 reports it.
#ifndef SPU_EMU_MFC_FAULT_H
#define SPU_EMU_MFC_FAULT_H

#include <exception>
#include <optional>
#include <string>

#include "mfc/command.h"

namespace spu_emu {

enum class Rule {
  transfer_size,
  natural_alignment,
  quadword_alignment,
  quadword_offset,
  tag,
  opcode,
  local_store_range,
  effective_address,
  list_size,
  list_address,
  list_crosses_4_gb,
  list_acknowledge,
  proxy_command,
  word_transfer,
  in_flight_overlap,
  in_flight_write,
  in_flight_source,
  in_flight_list,
  deadlock,
  tag_update,
  channel,
  halt,
  illegal_instruction,
  instruction_limit,
  local_store_full,
  stack_reserve,
  register_access,
  // Of programs as such, whatever the MFC does.
  memory_access,
  stack_overflow,
  heap_overrun,
  arithmetic,
  abort,
  exception,
  time_limit
};

/// The rule in a few words, for example "transfer size".
const char* rule_name(Rule rule);

/// How libspe2 reports a fault: the stop reason and the value that goes with it (libspe2-types.h).
struct StopReport {
  unsigned int reason;
  int value;
};

/// The report of a rule: misaligned or badly sized transfers SPE_DMA_ALIGNMENT, addresses SPE_DMA_STORAGE,
/// other commands SPE_INVALID_DMA; channel misuse and halt are runtime errors; a full local store, a limit
/// reached and what ends a program of any machine are fatal.
StopReport stop_report(Rule rule);

/// Thrown by the MFC when a rule is broken; the command has had no effect.
class Fault : public std::exception {
 public:
  Fault(Rule rule, std::string detail, std::optional<Command> command = std::nullopt);

  Rule rule() const { return rule_; }
  const std::optional<Command>& command() const { return command_; }
  /// One line: rule, detail, then command, LS address, EA, size, tag and source line as far as known.
  const std::string& text() const { return text_; }
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  Rule rule_;
  std::optional<Command> command_;
  std::string text_;
};

}  // namespace spu_emu

#endif
