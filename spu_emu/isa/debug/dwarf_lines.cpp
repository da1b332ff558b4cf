#include "isa/debug/dwarf_lines.h"

#include <dlfcn.h>
#include <elfutils/libdw.h>

#include <map>
#include <memory>
#include <vector>

namespace spu_emu::isa {

namespace {

/// The functions of libdw and libelf that are called here.
struct Libdw {
  decltype(&::elf_version) elf_version;
  decltype(&::elf_memory) elf_memory;
  decltype(&::elf_end) elf_end;
  decltype(&::dwarf_begin_elf) dwarf_begin_elf;
  decltype(&::dwarf_end) dwarf_end;
  decltype(&::dwarf_nextcu) dwarf_nextcu;
  decltype(&::dwarf_offdie) dwarf_offdie;
  decltype(&::dwarf_getsrclines) dwarf_getsrclines;
  decltype(&::dwarf_onesrcline) dwarf_onesrcline;
  decltype(&::dwarf_lineaddr) dwarf_lineaddr;
  decltype(&::dwarf_lineno) dwarf_lineno;
  decltype(&::dwarf_linesrc) dwarf_linesrc;
  decltype(&::dwarf_linebeginstatement) dwarf_linebeginstatement;
  decltype(&::dwarf_lineendsequence) dwarf_lineendsequence;
};

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
    return library != nullptr && find(library, "elf_version", dw.elf_version) &&
           find(library, "elf_memory", dw.elf_memory) && find(library, "elf_end", dw.elf_end) &&
           find(library, "dwarf_begin_elf", dw.dwarf_begin_elf) && find(library, "dwarf_end", dw.dwarf_end) &&
           find(library, "dwarf_nextcu", dw.dwarf_nextcu) && find(library, "dwarf_offdie", dw.dwarf_offdie) &&
           find(library, "dwarf_getsrclines", dw.dwarf_getsrclines) &&
           find(library, "dwarf_onesrcline", dw.dwarf_onesrcline) &&
           find(library, "dwarf_lineaddr", dw.dwarf_lineaddr) &&
           find(library, "dwarf_lineno", dw.dwarf_lineno) &&
           find(library, "dwarf_linesrc", dw.dwarf_linesrc) &&
           find(library, "dwarf_linebeginstatement", dw.dwarf_linebeginstatement) &&
           find(library, "dwarf_lineendsequence", dw.dwarf_lineendsequence) &&
           dw.elf_version(EV_CURRENT) != EV_NONE;
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

SourceLines read_lines(const Libdw& dw, std::vector<char>& file) {
  const std::unique_ptr<Elf, decltype(dw.elf_end)> elf(dw.elf_memory(file.data(), file.size()), dw.elf_end);
  if (!elf) return {};
  const std::unique_ptr<Dwarf, decltype(dw.dwarf_end)> dwarf(
      dw.dwarf_begin_elf(elf.get(), DWARF_C_READ, nullptr), dw.dwarf_end);
  return dwarf ? Reader(dw).read(dwarf.get()) : SourceLines();
}

}  // namespace

DwarfLines read_dwarf_lines(std::span<const std::byte> elf_file) {
  const Libdw* dw = find_libdw();
  if (dw == nullptr) return {{}, "Source lines are not known: libdw is not installed (Debian: libdw1)."};
  // libdw wants bytes that it may change.
  const auto* first = reinterpret_cast<const char*>(elf_file.data());
  std::vector<char> file(first, first + elf_file.size());
  SourceLines lines = read_lines(*dw, file);
  if (!lines.empty()) return {std::move(lines), {}};
  return {{}, "Source lines are not known: the program was compiled without -g."};
}

}  // namespace spu_emu::isa
