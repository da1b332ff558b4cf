#include "isa/debug/dwarf_lines.h"

#include <dlfcn.h>

#include <map>
#include <memory>
#include <vector>

#include "isa/debug/dwarf_variables.h"

namespace spu_emu::isa {

namespace {

template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

/// Once found it stays.
const Libdw* find_libdw() {
  static Libdw dw{};
  static const bool found = [] {
    void* library = dlopen("libdw.so.1", RTLD_NOW | RTLD_LOCAL);
#define SPU_EMU_FIND(name) &&find(library, #name, dw.name)
    return library != nullptr SPU_EMU_LIBDW_FUNCTIONS(SPU_EMU_FIND) && dw.elf_version(EV_CURRENT) != EV_NONE;
#undef SPU_EMU_FIND
  }();
  return found ? &dw : nullptr;
}

class Reader {
 public:
  explicit Reader(const Libdw& dw) : dw_(dw) {}

  SourceLines read(Dwarf* dwarf) {
    Dwarf_Off at = 0;
    Dwarf_Off next = 0;
    std::size_t header = 0;
    while (dw_.dwarf_nextcu(dwarf, at, &next, &header, nullptr, nullptr, nullptr) == 0) {
      Dwarf_Die unit{};
      if (dw_.dwarf_offdie(dwarf, at + header, &unit) != nullptr) read_unit(unit);
      at = next;
    }
    return {std::move(files_), std::move(rows_)};
  }

 private:
  void read_unit(Dwarf_Die& unit) {
    Dwarf_Lines* lines = nullptr;
    std::size_t count = 0;
    if (dw_.dwarf_getsrclines(&unit, &lines, &count) != 0) return;
    for (std::size_t i = 0; i < count; ++i) {
      if (Dwarf_Line* line = dw_.dwarf_onesrcline(lines, i)) read_line(line);
    }
  }

  void read_line(Dwarf_Line* line) {
    Dwarf_Addr address = 0;
    int number = 0;
    bool statement = false;
    bool end = false;
    const char* path = dw_.dwarf_linesrc(line, nullptr, nullptr);
    if (path == nullptr || dw_.dwarf_lineaddr(line, &address) != 0 || dw_.dwarf_lineno(line, &number) != 0 ||
        dw_.dwarf_linebeginstatement(line, &statement) != 0 || dw_.dwarf_lineendsequence(line, &end) != 0) {
      return;
    }
    rows_.push_back({static_cast<std::uint32_t>(address), file(path), static_cast<std::uint32_t>(number),
                     statement, end});
  }

  std::uint32_t file(const std::string& path) {
    const auto [place, is_new] = numbers_.try_emplace(path, static_cast<std::uint32_t>(files_.size()));
    if (is_new) files_.push_back(path);
    return place->second;
  }

  const Libdw& dw_;
  std::map<std::string, std::uint32_t> numbers_;
  std::vector<std::string> files_;
  std::vector<LineRow> rows_;
};

DwarfLines read_tables(const Libdw& dw, std::vector<char>& file) {
  const std::unique_ptr<Elf, decltype(dw.elf_end)> elf(dw.elf_memory(file.data(), file.size()), dw.elf_end);
  if (!elf) return {};
  const std::unique_ptr<Dwarf, decltype(dw.dwarf_end)> dwarf(
      dw.dwarf_begin_elf(elf.get(), DWARF_C_READ, nullptr), dw.dwarf_end);
  if (!dwarf) return {};
  return {Reader(dw).read(dwarf.get()), read_variables(dw, dwarf.get()), {}};
}

}  // namespace

DwarfLines read_dwarf_lines(std::span<const std::byte> elf_file) {
  const Libdw* dw = find_libdw();
  if (dw == nullptr) return {{}, {}, "Source lines are not known: libdw is not installed (Debian: libdw1)."};
  // libdw wants bytes that it may change.
  const auto* first = reinterpret_cast<const char*>(elf_file.data());
  std::vector<char> file(first, first + elf_file.size());
  DwarfLines tables = read_tables(*dw, file);
  if (!tables.lines.empty()) return tables;
  return {{}, {}, "Source lines are not known: the program was compiled without -g."};
}

}  // namespace spu_emu::isa
