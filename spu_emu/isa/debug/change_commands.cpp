// Variables, and the commands that change what a program has.
#include <array>
#include <bit>
#include <cerrno>
#include <cstdlib>

#include "isa/debug/commands.h"
#include "isa/debug/value_format.h"
#include "isa/debug/variable_value.h"
#include "isa/encoding/big_endian.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {

constexpr std::uint32_t kRegisterWidth = 16;
constexpr std::uint32_t kRegisterCount = 128;
constexpr const char* kSetUsage = "set WHAT [FORMAT] VALUE...";

using Kind = ValueFormat::Kind;

std::string print(Session& session, const Words& words) {
  check_count(words, 1, "print VARIABLE");
  if (words.empty()) {
    std::string text;
    for (const std::string& name : session.variables.names_at(session.machine.pc())) text += name + "\n";
    return text.empty() ? "No variables are known here.\n" : text;
  }
  return words.front() + " = " + value_text(session, find_value(session, words.front())) + "\n";
}

[[noreturn]] void fail_value(const std::string& text, const ValueFormat& value_format) {
  throw CommandError(format("\"%s\" does not fit into %u bits.", text.c_str(), 8 * value_format.element));
}

std::uint64_t float_bits(const std::string& text, unsigned size) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0') throw CommandError("\"" + text + "\" is no number.");
  return size == 4 ? std::bit_cast<std::uint32_t>(static_cast<float>(value))
                   : std::bit_cast<std::uint64_t>(value);
}

/// A number, else what stands for an address: a symbol, a register, sums of them.
std::uint64_t whole_bits(const Session& session, const std::string& text, const ValueFormat& value_format) {
  char* end = nullptr;
  errno = 0;
  const bool is_negative = text.starts_with('-');
  const std::uint64_t value = is_negative ? static_cast<std::uint64_t>(std::strtoll(text.c_str(), &end, 0))
                                          : std::strtoull(text.c_str(), &end, 0);
  if (end == text.c_str() || *end != '\0') return session.map.value(text, session.machine);
  const unsigned unused = value_format.element < 8 ? 64 - 8 * value_format.element : 0;
  const auto least = -(std::int64_t{1} << (63 - unused));
  const bool fits =
      is_negative ? static_cast<std::int64_t>(value) >= least : value <= ~std::uint64_t{0} >> unused;
  if (!fits || errno == ERANGE) fail_value(text, value_format);
  return value;
}

/// Each value as an element, in the SPU's order of bytes.
std::vector<std::byte> elements(const Session& session, const ValueFormat& value_format,
                                std::span<const std::string> values) {
  std::vector<std::byte> bytes;
  for (const std::string& text : values) {
    const std::uint64_t bits = value_format.kind == Kind::floating ? float_bits(text, value_format.element)
                                                                   : whole_bits(session, text, value_format);
    for (unsigned i = value_format.element; i-- > 0;)
      bytes.push_back(i < 8 ? static_cast<std::byte>(bits >> 8 * i) : std::byte{0});
  }
  return bytes;
}

void write_store(Session& session, std::uint32_t first, std::span<const std::byte> bytes) {
  check_bytes(first, bytes.size());
  std::copy(bytes.begin(), bytes.end(), session.store + first);
  session.machine.local_store_written(first, static_cast<std::uint32_t>(bytes.size()));
  session.breakpoints.accept_changes();
  session.stops_have_changed = true;
}

void write_register(Session& session, std::uint32_t number, std::uint32_t offset,
                    std::span<const std::byte> bytes) {
  if (offset + bytes.size() > kRegisterWidth)
    throw CommandError("A register has 16 bytes; these values have more.");
  std::array<std::byte, kRegisterWidth> all{};
  for (unsigned slot = 0; slot < 4; ++slot) write_word(&all[4 * slot], session.machine.word(number, slot));
  std::copy(bytes.begin(), bytes.end(), all.begin() + offset);
  for (unsigned slot = 0; slot < 4; ++slot) session.machine.set_word(number, slot, read_word(&all[4 * slot]));
}

/// The format in which a variable of the type is written; of several elements it is that of one.
const ValueFormat& format_of(const VariableType& type, const std::string& name) {
  using TypeKind = VariableType::Kind;
  const bool is_whole = type.kind == TypeKind::is_signed || type.kind == TypeKind::is_unsigned ||
                        type.kind == TypeKind::character || type.kind == TypeKind::enumeration ||
                        type.kind == TypeKind::pointer;
  for (const ValueFormat& each : value_formats()) {
    const bool same_kind =
        type.kind == TypeKind::floating ? each.kind == Kind::floating : each.kind == Kind::is_signed;
    if ((is_whole || type.kind == TypeKind::floating) && same_kind && each.element == type.size) return each;
  }
  throw CommandError("\"" + name + "\" is no single number: name an element or a member of it.");
}

std::string set_variable(Session& session, const std::string& name, const Words& values) {
  check_count(values, 1, "set VARIABLE VALUE");
  const VariableValue place = find_value(session, name);
  const ValueFormat& value_format = format_of(session.variables.types[place.type], name);
  const std::vector<std::byte> bytes = elements(session, value_format, values);
  if (place.in_register)
    write_register(session, place.at, place.offset, bytes);
  else
    write_store(session, place.at, bytes);
  return name + " = " + value_text(session, place) + "\n";
}

std::string set(Session& session, const Words& words) {
  if (words.size() < 2) throw CommandError(std::string("Set what to what? It is: ") + kSetUsage);
  const std::string& what = words.front();
  Words values(words.begin() + 1, words.end());
  if (values.size() > 1 && values.front() == "=") values.erase(values.begin());
  const ValueFormat* value_format = find_format(values.front());
  if (value_format == nullptr && is_variable(session, what)) return set_variable(session, what, values);
  if (value_format != nullptr) values.erase(values.begin());
  if (values.empty()) throw CommandError(std::string("There is no value: it is ") + kSetUsage);
  const std::vector<std::byte> bytes =
      elements(session, value_format != nullptr ? *value_format : default_format(), values);
  if (what == "pc" || what == "$pc") throw CommandError("Where the program goes on is not set by a command.");
  if (!what.starts_with('$')) {
    const std::uint32_t address = session.map.value(what, session.machine);
    write_store(session, address, bytes);
    return {};
  }
  const std::uint32_t number = number_in(what.substr(1));
  if (number >= kRegisterCount)
    throw CommandError(format("There is no register %u: they are $0 to $127.", number));
  write_register(session, number, 0, bytes);
  return {};
}

constexpr DebuggerCommand kChangeCommands[] = {
    {"print", "p", "[VARIABLE]", "A variable by its name, with its members and elements",
     "The name may be followed by .MEMBER, ->MEMBER and [NUMBER], and * before it follows\n"
     "a pointer. Without a name: which variables are known here. Needs -g; of an\n"
     "optimised program the compiler does not keep every value everywhere.\n"
     "Examples:\n"
     "  print sum\n"
     "  print board.scores[2]\n"
     "  print list->next->count\n"
     "  print *list\n",
     print},
    {"set", "", "WHAT [FORMAT] VALUE...", "Change a variable, a register or bytes of the local store",
     "A variable is named as for print and takes one number; with a format its name is an\n"
     "address. A register takes its first elements, memory as many as there are values;\n"
     "formats are those of registers, and words (x4) without one. A value may be a symbol\n"
     "or a sum, as an address may.\n"
     "Examples:\n"
     "  set board.count 3\n"
     "  set $3 float4 1.5 2 3 4\n"
     "  set $4 buffer+16\n"
     "  set 0x8000 short8 1 2 3\n",
     set},
};

}  // namespace

std::span<const DebuggerCommand> change_commands() {
  return kChangeCommands;
}

}  // namespace spu_emu::isa
