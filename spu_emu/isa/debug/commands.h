/// @file
/// The debugger's commands: their names, what they do, and what `help` says of them.
#ifndef SPU_EMU_ISA_DEBUG_COMMANDS_H
#define SPU_EMU_ISA_DEBUG_COMMANDS_H

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isa/debug/session.h"

namespace spu_emu::isa {

using Words = std::vector<std::string>;

struct DebuggerCommand {
  const char* name;
  const char* short_name;  // or empty
  const char* arguments;
  const char* summary;
  /// The rest of its help: rules and examples, whole lines.
  const char* details;
  /// Does it, and gives the text to show. Throws CommandError.
  std::string (*run)(Session& session, const Words& words);
};

/// By what they are for; each word of a line but the first is an argument.
std::span<const DebuggerCommand> run_commands();
std::span<const DebuggerCommand> stop_commands();
std::span<const DebuggerCommand> look_commands();
std::span<const DebuggerCommand> change_commands();

/// Does what a line says: a command's name, its short name, or so much of its name that no other begins so.
/// What is wrong with it comes back as text, too.
std::string execute(Session& session, std::string_view line);

/// All commands in a line each, or the whole help of one.
std::string help_text(const Words& words);

/// Throws CommandError when there are more words than `most`, with the command's arguments.
void check_count(const Words& words, std::size_t most, const char* usage);

}  // namespace spu_emu::isa

#endif
