/// @file
/// What an SPU ELF file tells beyond its memory image: symbols, sections and the program's name.
#ifndef SPU_EMU_ISA_ELF_ELF_SYMBOLS_H
#define SPU_EMU_ISA_ELF_ELF_SYMBOLS_H

#include <elf.h>

#include "isa/elf/elf_loader.h"

namespace spu_emu::isa {

/// Named addresses of the local store, by rising address. What is broken is left out.
std::vector<ElfSymbol> read_symbols(std::span<const std::byte> file, const Elf32_Ehdr& header);

/// Where the section .toe is; empty if there is none or if it is broken.
ElfRange read_toe(std::span<const std::byte> file, const Elf32_Ehdr& header);

/// The description of the "SPUNAME" note in a note segment; empty if there is none.
std::string read_name_note(std::span<const std::byte> notes);

}  // namespace spu_emu::isa

#endif
