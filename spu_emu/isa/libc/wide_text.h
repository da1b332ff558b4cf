/// @file
/// Wide characters of an SPU program, which have 32 bits, and the bytes that stand for them outside: UTF-8.
#ifndef SPU_EMU_ISA_LIBC_WIDE_TEXT_H
#define SPU_EMU_ISA_LIBC_WIDE_TEXT_H

#include <cstdint>
#include <optional>
#include <string>

#include "isa/libc/store_bytes.h"

namespace spu_emu::isa {

/// The bytes of one character; nothing if there is no such character.
std::optional<std::string> bytes_of(std::uint32_t character);

/// The bytes of the wide text at `ls`, of whole characters, `longest` bytes at most; nothing if a character
/// is none. Throws BadAddress.
std::optional<std::string> wide_text(const StoreBytes& store, std::uint32_t ls, std::uint32_t longest);

/// How many bytes a character has that begins with `first`; 0 if none does.
unsigned bytes_behind(unsigned char first);
/// The character of the bytes; nothing if they are not exactly one.
std::optional<std::uint32_t> character_of(const std::string& bytes);

}  // namespace spu_emu::isa

#endif
