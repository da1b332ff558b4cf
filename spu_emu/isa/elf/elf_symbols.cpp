#include "isa/elf/elf_symbols.h"

#include <algorithm>

#include "isa/elf/elf_format.h"
#include "mfc/command.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {
using Bytes = std::span<const std::byte>;

/// The NUL-ended text at `offset`, cut at the end of the table.
std::string text_at(Bytes table, std::uint32_t offset) {
  if (offset >= table.size()) return {};
  const Bytes rest = table.subspan(offset);
  const auto end = std::find(rest.begin(), rest.end(), std::byte{0});
  return {reinterpret_cast<const char*>(rest.data()), static_cast<std::size_t>(end - rest.begin())};
}

std::optional<Elf32_Shdr> section(Bytes file, const Elf32_Ehdr& header, std::uint32_t index) {
  const std::uint64_t offset = header.e_shoff + std::uint64_t{index} * sizeof(Elf32_Shdr);
  if (index >= header.e_shnum || header.e_shentsize != sizeof(Elf32_Shdr) ||
      !inside(file, offset, sizeof(Elf32_Shdr))) {
    return std::nullopt;
  }
  return section_header(file.data() + offset);
}

Bytes content(Bytes file, const Elf32_Shdr& section) {
  if (!inside(file, section.sh_offset, section.sh_size)) return {};
  return file.subspan(section.sh_offset, section.sh_size);
}

bool names_an_address(const Elf32_Sym& symbol) {
  const unsigned type = ELF32_ST_TYPE(symbol.st_info);
  const bool kind = type == STT_FUNC || type == STT_OBJECT || type == STT_NOTYPE;
  return kind && symbol.st_shndx != SHN_UNDEF && symbol.st_shndx != SHN_ABS &&
         symbol.st_value < kLocalStoreSize;
}

void add_symbols(Bytes table, Bytes names, std::vector<ElfSymbol>& symbols) {
  for (; table.size() >= sizeof(Elf32_Sym); table = table.subspan(sizeof(Elf32_Sym))) {
    const Elf32_Sym symbol = symbol_entry(table.data());
    if (!names_an_address(symbol)) continue;
    std::string name = text_at(names, symbol.st_name);
    if (!name.empty()) symbols.push_back({symbol.st_value, symbol.st_size, std::move(name)});
  }
}
}  // namespace

std::vector<ElfSymbol> read_symbols(Bytes file, const Elf32_Ehdr& header) {
  std::vector<ElfSymbol> symbols;
  for (std::uint32_t i = 0; i < header.e_shnum; ++i) {
    const auto table = section(file, header, i);
    if (!table || table->sh_type != SHT_SYMTAB) continue;
    const auto names = section(file, header, table->sh_link);
    if (names) add_symbols(content(file, *table), content(file, *names), symbols);
    break;  // A linked file has one symbol table; more would only make a broken file slow.
  }
  std::stable_sort(symbols.begin(), symbols.end(),
                   [](const ElfSymbol& a, const ElfSymbol& b) { return a.address < b.address; });
  return symbols;
}

ElfRange read_toe(Bytes file, const Elf32_Ehdr& header) {
  const auto names = section(file, header, header.e_shstrndx);
  if (!names) return {};
  for (std::uint32_t i = 0; i < header.e_shnum; ++i) {
    const auto toe = section(file, header, i);
    if (!toe || text_at(content(file, *names), toe->sh_name) != ".toe") continue;
    const bool whole = toe->sh_addr % 16 == 0 && toe->sh_size % 16 == 0;
    const bool fits = toe->sh_addr < kLocalStoreSize && toe->sh_size <= kLocalStoreSize - toe->sh_addr;
    return whole && fits ? ElfRange{toe->sh_addr, toe->sh_size} : ElfRange{};
  }
  return {};
}

std::string read_name_note(Bytes notes) {
  constexpr std::size_t kHeader = 12;
  constexpr std::string_view kOwner = "SPUNAME";
  const auto padded = [](std::uint64_t size) { return (size + 3) / 4 * 4; };
  while (notes.size() >= kHeader) {
    const std::uint64_t owner_size = read_word(notes.data());
    const std::uint64_t text_size = read_word(notes.data() + 4);
    const std::uint64_t text_offset = kHeader + padded(owner_size);
    if (!inside(notes, text_offset, text_size)) return {};
    if (text_at(notes.subspan(kHeader, owner_size), 0) == kOwner) {
      return text_at(notes.subspan(text_offset, text_size), 0);
    }
    const std::uint64_t next = text_offset + padded(text_size);
    if (next >= notes.size()) return {};
    notes = notes.subspan(next);
  }
  return {};
}

std::string nearest_symbol(const std::vector<ElfSymbol>& symbols, std::uint32_t address) {
  const auto behind =
      std::upper_bound(symbols.begin(), symbols.end(), address,
                       [](std::uint32_t wanted, const ElfSymbol& symbol) { return wanted < symbol.address; });
  if (behind == symbols.begin()) return {};
  const ElfSymbol& symbol = *(behind - 1);
  if (symbol.address == address) return symbol.name;
  return format("%s+0x%x", symbol.name.c_str(), address - symbol.address);
}

}  // namespace spu_emu::isa
