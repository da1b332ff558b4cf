#include "isa/debug/commands.h"

#include <sstream>

#include "mfc/format.h"

namespace spu_emu::isa {

namespace {

std::string help(Session&, const Words& words) {
  return help_text(words);
}

constexpr DebuggerCommand kHelp[] = {
    {"help", "h", "[COMMAND]", "This list, or all about one command, with examples", "", help}};

std::vector<std::span<const DebuggerCommand>> groups() {
  return {run_commands(), stop_commands(), look_commands(), change_commands(), kHelp};
}

Words split(std::string_view line) {
  std::istringstream stream{std::string(line)};
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

[[noreturn]] void fail_unknown(const std::string& name) {
  std::vector<std::string> names;
  for (const auto group : groups()) {
    for (const DebuggerCommand& each : group) names.emplace_back(each.name);
  }
  const std::string nearest = nearest_name(name, names);
  throw CommandError("There is no command \"" + name + "\"" +
                     (nearest.empty() ? "; " : "; the nearest is " + nearest + ", and ") +
                     "help lists all of them.");
}

/// A name or short name as it is comes before the beginning of one.
const DebuggerCommand& find_command(const std::string& name) {
  std::vector<const DebuggerCommand*> beginning;
  for (const auto group : groups()) {
    for (const DebuggerCommand& each : group) {
      if (name == each.name || name == each.short_name) return each;
      if (std::string_view(each.name).starts_with(name)) beginning.push_back(&each);
    }
  }
  if (beginning.size() == 1) return *beginning.front();
  if (beginning.empty()) fail_unknown(name);
  std::string names;
  for (const DebuggerCommand* each : beginning)
    names += (names.empty() ? "" : ", ") + std::string(each->name);
  throw CommandError("\"" + name + "\" is the beginning of several commands: " + names + ".");
}

std::string command_line(const DebuggerCommand& command) {
  std::string name = command.name;
  if (*command.short_name != '\0') name += std::string(", ") + command.short_name;
  return format("  %-17s %s\n", name.c_str(), command.summary);
}

std::string all_commands() {
  constexpr const char* kTitles[] = {"Run:", "Stop:", "Look:", "Variables and changes:", "Learn:"};
  std::string text = "The SPU stands still while you type; the host program and other SPEs go on.\n";
  std::size_t group_number = 0;
  for (const auto group : groups()) {
    text += std::string(kTitles[group_number++]) + "\n";
    for (const DebuggerCommand& each : group) text += command_line(each);
  }
  return text +
         "Names may be cut as long as one command begins so. Examples to begin with:\n"
         "  break main\n"
         "  continue\n"
         "  registers int4 3-5\n"
         "Ctrl-C stops a program that runs or waits. At the end of the commands, or by\n"
         "Ctrl-D, the program runs on to its end.\n";
}

}  // namespace

std::string help_text(const Words& words) {
  check_count(words, 1, "help [COMMAND]");
  if (words.empty()) return all_commands();
  const DebuggerCommand& command = find_command(words.front());
  const std::string usage =
      std::string(command.name) + (*command.arguments == '\0' ? "" : " ") + command.arguments;
  const std::string shorter =
      *command.short_name == '\0' ? "" : std::string("   or for short: ") + command.short_name;
  return usage + shorter + "\n" + command.summary + ".\n" + command.details;
}

void check_count(const Words& words, std::size_t most, const char* usage) {
  if (words.size() > most) throw CommandError("\"" + words[most] + "\" is too much; it is: " + usage);
}

std::string execute(Session& session, std::string_view line) {
  Words words = split(line);
  if (words.empty()) return {};
  try {
    const DebuggerCommand& command = find_command(words.front());
    words.erase(words.begin());
    return command.run(session, words);
  } catch (const CommandError& error) {
    return std::string(error.what()) + "\n";
  }
}

}  // namespace spu_emu::isa
