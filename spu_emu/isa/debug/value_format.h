/// @file
/// Quadwords as text: elements of any width, as numbers of any kind.
#ifndef SPU_EMU_ISA_DEBUG_VALUE_FORMAT_H
#define SPU_EMU_ISA_DEBUG_VALUE_FORMAT_H

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace spu_emu::isa {

/// How elements are shown; named by kind and number of elements in a quadword, as the SDK names vectors.
struct ValueFormat {
  enum class Kind { hexadecimal, is_signed, is_unsigned, floating };
  const char* name;
  Kind kind;
  unsigned element;  // bytes
};

std::span<const ValueFormat> value_formats();
/// The one for words in hexadecimal.
const ValueFormat& default_format();
/// Null when there is none of this name.
const ValueFormat* find_format(std::string_view name);

/// The elements in columns; `bytes` are in the SPU's order, and a multiple of the element's size.
std::string format_elements(const ValueFormat& format, std::span<const std::byte> bytes);
/// Printable characters, points for the others.
std::string format_characters(std::span<const std::byte> bytes);

}  // namespace spu_emu::isa

#endif
