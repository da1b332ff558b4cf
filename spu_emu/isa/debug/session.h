/// @file
/// What a debugger knows between two commands: the program, where it is to stop, how far it is to run.
#ifndef SPU_EMU_ISA_DEBUG_SESSION_H
#define SPU_EMU_ISA_DEBUG_SESSION_H

#include <chrono>
#include <optional>
#include <string>

#include "isa/debug/breakpoints.h"
#include "isa/debug/call_stack.h"
#include "isa/debug/code_map.h"
#include "isa/debug/run_plan.h"
#include "isa/debug/variables.h"
#include "spe/spe.h"

namespace spu_emu::isa {

/// For the SPU's own thread.
struct Session {
  Spe& spe;
  Machine& machine;
  std::byte* store;
  CodeMap map;
  /// Why no source lines are known; empty when they are.
  std::string no_lines;
  Variables variables{};
  Breakpoints breakpoints{store};

  // What the commands have asked for.
  RunPlan plan{};
  bool goes_on = false;
  std::optional<std::chrono::milliseconds> time{};
  bool quits = false;
  bool stops_have_changed = false;

  /// The program broke a rule and can only end.
  bool is_over = false;

  std::uint32_t word(std::uint32_t address) const;
  std::vector<Frame> frames() const { return call_stack(machine, store, map); }
  /// Where the program stands: address, symbol, line, instruction, and the text of the line. Ends in a
  /// newline.
  std::string standing() const;
  /// A line of source with its number and a newline; only the number where the file is not there.
  std::string source_text(const LineRow& row) const;
};

}  // namespace spu_emu::isa

#endif
