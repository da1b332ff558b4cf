/// @file
/// The tables of a 32-bit big-endian ELF file as structs in host order.
#ifndef SPU_EMU_ISA_ELF_ELF_FORMAT_H
#define SPU_EMU_ISA_ELF_ELF_FORMAT_H

#include <elf.h>

#include <optional>
#include <span>

#include "isa/encoding/big_endian.h"

namespace spu_emu::isa {

/// True if [offset, offset + size) lies inside the file.
inline bool inside(std::span<const std::byte> file, std::uint64_t offset, std::uint64_t size) {
  return offset <= file.size() && size <= file.size() - offset;
}

/// The callers have checked that the whole struct is there.
inline Elf32_Ehdr elf_header(const std::byte* at) {
  Elf32_Ehdr header{};
  std::memcpy(header.e_ident, at, EI_NIDENT);
  header.e_type = read_half(at + 16);
  header.e_machine = read_half(at + 18);
  header.e_version = read_word(at + 20);
  header.e_entry = read_word(at + 24);
  header.e_phoff = read_word(at + 28);
  header.e_shoff = read_word(at + 32);
  header.e_phentsize = read_half(at + 42);
  header.e_phnum = read_half(at + 44);
  header.e_shentsize = read_half(at + 46);
  header.e_shnum = read_half(at + 48);
  header.e_shstrndx = read_half(at + 50);
  return header;
}

inline Elf32_Phdr segment_header(const std::byte* at) {
  Elf32_Phdr header{};
  header.p_type = read_word(at);
  header.p_offset = read_word(at + 4);
  header.p_vaddr = read_word(at + 8);
  header.p_filesz = read_word(at + 16);
  header.p_memsz = read_word(at + 20);
  header.p_flags = read_word(at + 24);
  return header;
}

inline Elf32_Shdr section_header(const std::byte* at) {
  Elf32_Shdr header{};
  header.sh_name = read_word(at);
  header.sh_type = read_word(at + 4);
  header.sh_addr = read_word(at + 12);
  header.sh_offset = read_word(at + 16);
  header.sh_size = read_word(at + 20);
  header.sh_link = read_word(at + 24);
  header.sh_entsize = read_word(at + 36);
  return header;
}

inline Elf32_Sym symbol_entry(const std::byte* at) {
  Elf32_Sym symbol{};
  symbol.st_name = read_word(at);
  symbol.st_value = read_word(at + 4);
  symbol.st_size = read_word(at + 8);
  symbol.st_info = std::to_integer<unsigned char>(at[12]);
  symbol.st_shndx = read_half(at + 14);
  return symbol;
}

}  // namespace spu_emu::isa

#endif
