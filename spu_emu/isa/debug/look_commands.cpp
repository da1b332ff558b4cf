// Commands that show the state of the program, and change nothing.
#include <algorithm>
#include <array>

#include "isa/debug/commands.h"
#include "isa/debug/mfc_view.h"
#include "isa/debug/value_format.h"
#include "isa/encoding/big_endian.h"
#include "isa/encoding/disassembler.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {

constexpr unsigned kRegisters = 128;
constexpr std::uint32_t kRow = 16;

/// Takes a format's name out of the words, if there is one.
const ValueFormat& take_format(Words& words) {
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (const ValueFormat* found = find_format(*word)) {
      words.erase(word);
      return *found;
    }
  }
  return default_format();
}

[[noreturn]] void fail_format(const std::string& text) {
  std::string names;
  for (const ValueFormat& each : value_formats()) names += std::string(" ") + each.name;
  throw CommandError("\"" + text + "\" is neither a register (0 to 127, or 3-7) nor a format:" + names + ".");
}

std::uint32_t register_number(const std::string& text, const std::string& whole) {
  const std::string digits = text.starts_with('$') || text.starts_with('r') ? text.substr(1) : text;
  const bool numeric = !digits.empty() &&
                       std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!numeric) fail_format(whole);
  const std::uint32_t number = number_in(digits);
  if (number >= kRegisters) throw CommandError(format("There is no register %u: they are 0 to 127.", number));
  return number;
}

std::string register_line(const Session& session, const ValueFormat& value_format, unsigned number) {
  std::array<std::byte, kRow> bytes{};
  for (unsigned slot = 0; slot < 4; ++slot)
    write_word(bytes.data() + 4 * slot, session.machine.word(number, slot));
  return format("r%-3u %s\n", number, format_elements(value_format, bytes).c_str());
}

std::string registers(Session& session, const Words& words) {
  Words rest = words;
  const ValueFormat& value_format = take_format(rest);
  if (rest.empty()) rest = {"0-127"};
  std::string text;
  for (const std::string& each : rest) {
    const std::size_t dash = each.find('-');
    const std::uint32_t first = register_number(each.substr(0, dash), each);
    const std::uint32_t last =
        dash == std::string::npos ? first : register_number(each.substr(dash + 1), each);
    if (last < first)
      throw CommandError("\"" + each + "\" goes from high to low: write the lower number first.");
    for (std::uint32_t number = first; number <= last; ++number)
      text += register_line(session, value_format, number);
  }
  return text;
}

std::string memory_row(const Session& session, const ValueFormat& value_format, std::uint32_t address,
                       std::uint32_t size) {
  const std::span<const std::byte> bytes(session.store + address, size);
  std::string elements = format_elements(value_format, bytes);
  if (value_format.kind == ValueFormat::Kind::hexadecimal) {
    const std::size_t whole = 2 * kRow + kRow / value_format.element - 1;
    elements.resize(std::max(whole, elements.size()), ' ');
    elements += "  " + format_characters(bytes);
  }
  return format("0x%05x  %s\n", address, elements.c_str());
}

std::string memory(Session& session, const Words& words) {
  const char* usage = "memory ADDRESS [SIZE] [FORMAT]";
  Words rest = words;
  const ValueFormat& value_format = take_format(rest);
  if (rest.empty()) throw CommandError(std::string("Which memory? It is: ") + usage);
  check_count(rest, 2, usage);
  const std::uint32_t first = session.map.value(rest.front(), session.machine);
  const std::uint32_t asked = rest.size() == 2 ? session.map.value(rest[1], session.machine) : 4 * kRow;
  const std::uint64_t size =
      (std::uint64_t{asked} + value_format.element - 1) / value_format.element * value_format.element;
  check_bytes(first, size);
  std::string text;
  for (std::uint32_t done = 0; done < size; done += kRow) {
    text += memory_row(session, value_format, first + done,
                       std::min<std::uint32_t>(kRow, static_cast<std::uint32_t>(size) - done));
  }
  return text;
}

/// A line of source before the first instruction of it.
std::string source_before(const Session& session, std::uint32_t address, bool is_first) {
  const auto row = session.map.lines().at(address);
  if (!row || (!is_first && row->address != address)) return {};
  return session.map.line_text(address) + ": " + session.source_text(*row).substr(7);
}

std::string instruction_line(const Session& session, std::uint32_t address) {
  std::string text = disassemble(session.word(address), address);
  std::replace(text.begin(), text.end(), '\t', ' ');
  return format("%s 0x%05x  %-20s %s\n", address == session.machine.pc() ? "=>" : "  ", address,
                session.map.symbol_text(address).c_str(), text.c_str());
}

std::string disassembly(Session& session, const Words& words) {
  constexpr std::uint32_t kUsual = 12;
  check_count(words, 2, "disassemble [WHERE] [COUNT]");
  std::uint32_t address =
      words.empty() ? session.machine.pc() : session.map.code(words.front(), session.machine).front();
  const std::uint32_t count = words.size() == 2 ? number_in(words[1]) : kUsual;
  std::string text;
  for (std::uint32_t i = 0; i < count && address < kLocalStoreSize; ++i, address += 4) {
    text += source_before(session, address, i == 0) + instruction_line(session, address);
  }
  return text;
}

std::string list(Session& session, const Words& words) {
  constexpr std::uint32_t kAround = 5;
  check_count(words, 1, "list [WHERE]");
  const std::uint32_t address =
      words.empty() ? session.machine.pc() : session.map.code(words.front(), session.machine).front();
  const auto row = session.map.lines().at(address);
  if (!row) {
    throw CommandError(session.no_lines.empty() ? format("No source line is known for 0x%05x.", address)
                                                : session.no_lines);
  }
  const std::uint32_t first = row->line > kAround ? row->line - kAround : 1;
  const std::string& path = session.map.lines().file(row->file);
  const auto lines = read_source(path, first, row->line + kAround);
  if (lines.empty()) throw CommandError(path + " cannot be read here.");
  std::string text;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    text += format("%s %-4u %s\n", first + i == row->line ? "=>" : "  ", first + i, lines[i].c_str());
  }
  return text;
}

std::string backtrace(Session& session, const Words& words) {
  check_count(words, 0, "backtrace");
  std::string text;
  unsigned number = 0;
  for (const Frame& frame : session.frames()) {
    // A caller stands behind its call.
    const std::uint32_t at = number == 0 ? frame.pc : frame.pc - 4;
    text += format("#%-3u %s\n", number, session.map.place(at).c_str());
    ++number;
  }
  return text;
}

std::string where(Session& session, const Words& words) {
  check_count(words, 1, "where [ADDRESS]");
  if (words.empty()) return session.standing();
  const std::uint32_t address = session.map.value(words.front(), session.machine);
  check_bytes(address, 1);
  return session.map.place(address) + "\n";
}

template <std::string (*Text)(Spe&)>
std::string show(Session& session, const Words& words) {
  if (!words.empty()) throw CommandError("This command takes no arguments.");
  return Text(session.spe);
}

constexpr DebuggerCommand kLookCommands[] = {
    {"where", "", "[ADDRESS]", "Where the program stands, or what an address belongs to",
     "Example:\n  where 0x1a4\n", where},
    {"backtrace", "bt", "", "The functions that have called each other, the innermost first",
     "Follows the back chain of the SPU's ABI from r1; the innermost function's\n"
     "prologue is read to know how far it is.\n",
     backtrace},
    {"list", "l", "[WHERE]", "Source around a place", "Example:\n  list kernel.c:41\n", list},
    {"disassemble", "dis", "[WHERE] [COUNT]", "Instructions from a place on, between their lines of source",
     "Examples:\n  disassemble\n  disassemble main 20\n", disassembly},
    {"registers", "r", "[FORMAT] [NUMBERS]", "Registers, as elements of any width",
     "A format has a kind and the number of elements in a quadword, as the SDK's\n"
     "vectors have: x1 x2 x4 x8 x16 (hexadecimal; x4 is the usual one), char16\n"
     "uchar16 short8 ushort8 int4 uint4 llong2 ullong2 float4 double2. Element 0, the\n"
     "preferred one of 32 and 64 bits, is on the left.\n"
     "Examples:\n"
     "  registers              all of them\n"
     "  registers 3            the first argument, and what a function returns\n"
     "  registers float4 3-6 80\n",
     registers},
    {"memory", "m", "ADDRESS [SIZE] [FORMAT]", "Bytes of the local store, as elements of any width",
     "64 bytes are the usual size; formats are those of registers.\n"
     "Examples:\n"
     "  memory buffer\n"
     "  memory $1 256          from the address in r1, the stack pointer\n"
     "  memory 0x8000 32 float4\n",
     memory},
    {"queue", "", "", "The MFC's queue, the proxy queue, and tags",
     "Tags are numbers 0 to 31; the mask is that of MFC_WrTagMask.\n", show<queue_text>},
    {"mailboxes", "", "", "What is in the mailboxes, unread", "", show<mailboxes_text>},
    {"signals", "", "", "The two signal registers, unread", "", show<signals_text>},
    {"events", "", "", "Events that are pending, and those the program asked for", "", show<events_text>},
    {"spes", "", "", "All SPEs of the process: which runs, and which waits for what", "", show<spes_text>},
};

}  // namespace

std::span<const DebuggerCommand> look_commands() {
  return kLookCommands;
}

}  // namespace spu_emu::isa
