// Commands that say where the program is to stop.
#include <algorithm>
#include <cctype>

#include "isa/debug/channel_names.h"
#include "isa/debug/commands.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {

std::string place_lines(const Session& session, const Breakpoint& breakpoint) {
  std::string text;
  for (const std::uint32_t address : breakpoint.addresses) {
    text += format("breakpoint %u at %s\n", breakpoint.number, session.map.place(address).c_str());
  }
  return text;
}

std::string add_break(Session& session, const Words& words, bool temporary, const char* usage) {
  check_count(words, 1, usage);
  const std::string where = words.empty() ? "pc" : words.front();
  Breakpoint breakpoint;
  breakpoint.text = where;
  breakpoint.temporary = temporary;
  breakpoint.addresses = session.map.code(where, session.machine);
  session.stops_have_changed = true;
  return place_lines(session, session.breakpoints.add(std::move(breakpoint)));
}

std::string break_at(Session& session, const Words& words) {
  return add_break(session, words, false, "break [WHERE]");
}
std::string break_once(Session& session, const Words& words) {
  return add_break(session, words, true, "tbreak [WHERE]");
}

/// The number of the channel that the words begin with, if they do.
std::optional<std::uint32_t> channel_in(Words& words) {
  if (words.front() == "channel") {
    if (words.size() < 2) throw CommandError("Which channel? For example: watch channel 21");
    const std::string text = words[1];
    words.erase(words.begin(), words.begin() + 2);
    if (const auto number = channel_named(text)) return number;
    const std::uint32_t number = number_in(text);
    if (number > 127) throw CommandError(format("There is no channel %u: they are 0 to 127.", number));
    return number;
  }
  const auto number = channel_named(words.front());
  if (number) words.erase(words.begin());
  return number;
}

std::string watch_channel(Session& session, std::uint32_t channel, const Words& rest) {
  check_count(rest, 1, "watch CHANNEL [read | write]");
  const std::string side = rest.empty() ? "" : rest.front();
  if (!side.empty() && side != "read" && side != "write")
    throw CommandError("A channel is watched for read or for write, or without a word for both.");
  Breakpoint breakpoint;
  breakpoint.is_channel = true;
  breakpoint.channel = channel;
  breakpoint.on_read = side != "write";
  breakpoint.on_write = side != "read";
  breakpoint.text =
      format("channel %u, %s%s%s", channel, channel_name(channel), side.empty() ? "" : ", ", side.c_str());
  session.stops_have_changed = true;
  const Breakpoint& added = session.breakpoints.add(std::move(breakpoint));
  return format("watchpoint %u: %s\n", added.number, added.text.c_str());
}

/// The size that a symbol has, if the text is one.
std::uint32_t size_of_symbol(const Session& session, const std::string& text) {
  for (const ElfSymbol& symbol : session.map.symbols()) {
    if (symbol.name == text && symbol.size != 0) return symbol.size;
  }
  return 4;
}

std::string watch_bytes(Session& session, Words words) {
  const char* usage = "watch ADDRESS [SIZE] [always]";
  Breakpoint breakpoint;
  breakpoint.any_store = words.back() == "always" && words.size() > 1;
  if (breakpoint.any_store) words.pop_back();
  check_count(words, 2, usage);
  breakpoint.first = session.map.value(words.front(), session.machine);
  breakpoint.size = words.size() == 2 ? session.map.value(words[1], session.machine)
                                      : size_of_symbol(session, words.front());
  if (breakpoint.size == 0) throw CommandError("A range of 0 bytes cannot be watched.");
  check_bytes(breakpoint.first, breakpoint.size);
  breakpoint.text =
      format("LS 0x%05x to 0x%05x, %u bytes%s", breakpoint.first, breakpoint.first + breakpoint.size - 1,
             breakpoint.size, breakpoint.any_store ? ", every store" : "");
  session.stops_have_changed = true;
  const Breakpoint& added = session.breakpoints.add(std::move(breakpoint));
  return format("watchpoint %u: %s\n", added.number, added.text.c_str());
}

std::string watch(Session& session, const Words& words) {
  if (words.empty()) throw CommandError("Watch what? For example: watch counter, or watch MFC_Cmd");
  Words rest = words;
  if (const auto channel = channel_in(rest)) return watch_channel(session, *channel, rest);
  return watch_bytes(session, rest);
}

std::string list_breakpoints(Session& session, const Words& words) {
  check_count(words, 0, "breakpoints");
  std::string text;
  for (const Breakpoint& each : session.breakpoints.all()) {
    const std::string where = each.addresses.empty() ? each.text : session.map.place(each.addresses.front());
    const std::string more =
        each.addresses.size() > 1 ? format(" and %zu places more", each.addresses.size() - 1) : "";
    text += format("%-3u %s%s, met %llu times\n", each.number, where.c_str(), more.c_str(),
                   static_cast<unsigned long long>(each.hits));
  }
  return text.empty() ? "There are none. For example: break main\n" : text;
}

std::string remove_breakpoints(Session& session, const Words& words) {
  check_count(words, 1, "delete [NUMBER]");
  session.stops_have_changed = true;
  if (words.empty()) {
    session.breakpoints.remove_all();
    return "All breakpoints and watchpoints are gone.\n";
  }
  const std::uint32_t number = number_in(words.front());
  if (!session.breakpoints.remove(number)) {
    throw CommandError(format("There is no breakpoint %u; breakpoints lists them.", number));
  }
  return {};
}

constexpr DebuggerCommand kStopCommands[] = {
    {"break", "b", "[WHERE]", "Stop before an instruction: of a symbol, a line, an address",
     "Without WHERE it is the instruction that is next.\n"
     "Examples:\n"
     "  break main           a function's first instruction\n"
     "  break kernel.c:41    a line of source, or the next one that has code; needs -g\n"
     "  break 41             a line of the file that the program stands in\n"
     "  break 0x1a4          an address\n"
     "  break main+0x24\n",
     break_at},
    {"tbreak", "tb", "[WHERE]", "The same, once", "Example:\n  tbreak main\n", break_once},
    {"watch", "w", "ADDRESS [SIZE] | CHANNEL", "Stop at writes to bytes of the local store, or at a channel",
     "watch ADDRESS [SIZE] [always]: stops before an instruction changes one of these\n"
     "bytes, and after a transfer or the host did. An SPU stores whole quadwords, also\n"
     "for a single byte; with `always` every store to a quadword of the range stops,\n"
     "whether a byte of it changes or not. SIZE is the symbol's, else 4.\n"
     "watch CHANNEL [read | write]: stops before the instruction; channels have the\n"
     "SDK's names or numbers.\n"
     "Examples:\n"
     "  watch counter\n"
     "  watch 0x8000 128\n"
     "  watch $3 16 always\n"
     "  watch MFC_Cmd\n"
     "  watch channel 29 read\n",
     watch},
    {"breakpoints", "", "", "List what was set by break and watch, and how often it was met", "",
     list_breakpoints},
    {"delete", "d", "[NUMBER]", "Remove one of them, or all", "Example:\n  delete 2\n", remove_breakpoints},
};

}  // namespace

std::span<const DebuggerCommand> stop_commands() {
  return kStopCommands;
}

}  // namespace spu_emu::isa
