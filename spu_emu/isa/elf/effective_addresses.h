/// @file
/// Addresses of the host's symbols that an SPU program knows by name.
#ifndef SPU_EMU_ISA_ELF_EFFECTIVE_ADDRESSES_H
#define SPU_EMU_ISA_ELF_EFFECTIVE_ADDRESSES_H

#include <string>

#include "isa/elf/elf_loader.h"

namespace spu_emu::isa {

/// Fills the section .toe, in the local store: `shadow` has a quadword for each of its quadwords, whose first
/// doubleword, in the host's byte order, is the address. Does nothing without a shadow or a section. What is
/// wrong, or nothing.
std::string place_effective_addresses(const ElfRange& toe, const void* shadow, std::byte* local_store);

}  // namespace spu_emu::isa

#endif
