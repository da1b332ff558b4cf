#include "isa/debug/code_map.h"

#include <cxxabi.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <optional>

#include "mfc/command.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {

bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string quoted(std::string_view text) {
  return '"' + std::string(text) + '"';
}

/// How many letters must change to make one of the other.
std::size_t distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t changed = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// The name of a C++ function as its source has it, without parameters; others as they are.
std::string source_name(const std::string& symbol) {
  if (!symbol.starts_with("_Z")) return symbol;
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  if (status != 0) return symbol;
  const std::string_view name = text.get();
  return std::string(name.substr(0, name.find('(')));
}

}  // namespace

CodeMap::CodeMap(std::vector<ElfSymbol> symbols, SourceLines lines)
    : symbols_(std::move(symbols)), lines_(std::move(lines)) {
  for (ElfSymbol& symbol : symbols_) symbol.name = source_name(symbol.name);
}

std::string nearest_name(std::string_view text, const std::vector<std::string>& names) {
  std::string nearest;
  std::size_t least = text.size() / 3 + 2;
  for (const std::string& name : names) {
    const std::size_t here = distance(text, name);
    if (here < least) {
      least = here;
      nearest = name;
    }
  }
  return nearest;
}

std::uint32_t number_in(std::string_view text) {
  const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
  const std::string_view digits = is_hex ? text.substr(2) : text;
  std::uint32_t number = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), number, is_hex ? 16 : 10);
  if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size()) {
    throw CommandError(quoted(text) + " is no number: write 12 or 0xc, 0xffffffff at most.");
  }
  return number;
}

void check_code_address(std::uint32_t address) {
  if (address >= kLocalStoreSize) {
    throw CommandError(
        format("0x%x is beyond the %u bytes of the local store: its last instruction is at 0x%x.", address,
               kLocalStoreSize, kLocalStoreSize - 4));
  }
  if (address % 4 != 0) {
    throw CommandError(format("0x%x is no multiple of 4, as addresses of instructions are.", address));
  }
}

void check_bytes(std::uint32_t first, std::uint64_t size) {
  const std::uint64_t end = first + size;
  if (end <= kLocalStoreSize) return;
  throw CommandError(format("%llu bytes at 0x%x end at 0x%llx, beyond the %u bytes of the local store.",
                            static_cast<unsigned long long>(size), first,
                            static_cast<unsigned long long>(end), kLocalStoreSize));
}

/// Symbols of one address may be many, and labels lie inside of functions: one with a size that reaches so
/// far is preferred.
const ElfSymbol* CodeMap::symbol_at(std::uint32_t address) const {
  const auto behind =
      std::upper_bound(symbols_.begin(), symbols_.end(), address,
                       [](std::uint32_t wanted, const ElfSymbol& symbol) { return wanted < symbol.address; });
  if (behind == symbols_.begin()) return nullptr;
  for (auto at = behind; at != symbols_.begin();) {
    --at;
    if (at->size != 0 && address - at->address < at->size) return &*at;
  }
  return &*(behind - 1);
}

std::string CodeMap::symbol_text(std::uint32_t address) const {
  const ElfSymbol* symbol = symbol_at(address);
  if (symbol == nullptr) return {};
  if (symbol->address == address) return symbol->name;
  return format("%s+0x%x", symbol->name.c_str(), address - symbol->address);
}

std::string CodeMap::line_text(std::uint32_t address) const {
  const auto row = lines_.at(address);
  if (!row) return {};
  return format("%s:%u", file_name(lines_.file(row->file)).c_str(), row->line);
}

std::string CodeMap::place(std::uint32_t address) const {
  std::string text = format("0x%05x", address);
  if (const std::string symbol = symbol_text(address); !symbol.empty()) text += " in " + symbol;
  if (const std::string line = line_text(address); !line.empty()) text += " (" + line + ")";
  return text;
}

/// In C++ functions of several parameter lists may have one name.
std::vector<std::uint32_t> CodeMap::symbol_addresses(std::string_view name) const {
  std::vector<std::uint32_t> addresses;
  for (const ElfSymbol& symbol : symbols_) {
    const bool is_new = addresses.empty() || addresses.back() != symbol.address;
    if (symbol.name == name && is_new) addresses.push_back(symbol.address);
  }
  return addresses;
}

std::uint32_t CodeMap::symbol_address(std::string_view name) const {
  if (const auto addresses = symbol_addresses(name); !addresses.empty()) return addresses.front();
  if (symbols_.empty()) {
    throw CommandError("The program has no symbols (it is stripped): write an address, for example 0x80.");
  }
  std::vector<std::string> names;
  for (const ElfSymbol& symbol : symbols_) names.push_back(symbol.name);
  const std::string nearest = nearest_name(name, names);
  throw CommandError("There is no symbol " + quoted(name) +
                     (nearest.empty() ? "." : "; the nearest is " + nearest + "."));
}

std::uint32_t CodeMap::term(std::string_view text, const Machine& machine) const {
  if (text == "pc" || text == "$pc") return machine.pc();
  if (text.starts_with('$')) {
    const std::uint32_t reg = number_in(text.substr(1));
    if (reg > 127) throw CommandError(format("There is no register %u: they are $0 to $127.", reg));
    return machine.word(reg, 0);
  }
  if (!text.empty() && text.front() >= '0' && text.front() <= '9') return number_in(text);
  return symbol_address(text);
}

std::uint32_t CodeMap::value(std::string_view text, const Machine& machine) const {
  std::uint32_t sum = 0;
  bool minus = false;
  for (std::string_view rest = text;;) {
    const std::size_t sign = rest.find_first_of("+-");
    const std::string_view part = rest.substr(0, sign);
    if (part.empty()) throw CommandError(quoted(text) + " is no address: write for example main+0x10.");
    const std::uint32_t value = term(part, machine);
    sum = minus ? sum - value : sum + value;
    if (sign == std::string_view::npos) return sum;
    minus = rest[sign] == '-';
    rest = rest.substr(sign + 1);
  }
}

/// The file that `name` means; without a name the one that the program stands in.
std::uint32_t CodeMap::one_file(std::string_view name, const Machine& machine) const {
  if (name.empty()) {
    const auto row = lines_.at(machine.pc());
    if (row) return row->file;
    throw CommandError("No line is known where the program stands: write FILE:LINE.");
  }
  const auto files = lines_.files_named(name);
  if (files.empty()) throw CommandError("No code of the program comes from a file " + quoted(name) + ".");
  return files.front();
}

/// The first instruction of the line in each function that has some.
std::vector<std::uint32_t> CodeMap::line_code(std::string_view file, std::string_view line,
                                              const Machine& machine) const {
  if (lines_.empty()) {
    throw CommandError("No source lines are known: compile with -g, or break at a symbol or an address.");
  }
  const std::uint32_t number = one_file(file, machine);
  const auto code = lines_.code_of(number, number_in(line));
  if (!code) {
    throw CommandError(format("%s has no code at line %s or behind it: its last line with code is %u.",
                              file_name(lines_.file(number)).c_str(), std::string(line).c_str(),
                              lines_.last_line(number)));
  }
  std::vector<std::uint32_t> first;
  std::vector<const ElfSymbol*> functions;
  for (const std::uint32_t address : code->addresses) {
    const ElfSymbol* function = symbol_at(address);
    if (std::find(functions.begin(), functions.end(), function) != functions.end()) continue;
    functions.push_back(function);
    first.push_back(address);
  }
  return first;
}

std::vector<std::uint32_t> CodeMap::code(std::string_view text, const Machine& machine) const {
  const std::size_t colon = text.rfind(':');
  if (colon != std::string_view::npos && colon != 0 && is_digits(text.substr(colon + 1))) {
    return line_code(text.substr(0, colon), text.substr(colon + 1), machine);
  }
  if (is_digits(text)) return line_code({}, text, machine);
  if (text.starts_with('*')) text.remove_prefix(1);
  std::vector<std::uint32_t> addresses = symbol_addresses(text);
  if (addresses.empty()) addresses.push_back(value(text, machine));
  for (const std::uint32_t address : addresses) check_code_address(address);
  return addresses;
}

}  // namespace spu_emu::isa
