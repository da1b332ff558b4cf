#include "isa/libc/wide_text.h"

namespace spu_emu::isa {

namespace {
constexpr bool is_character(std::uint32_t code) {
  return code < 0x110000 && (code < 0xd800 || code > 0xdfff);
}

constexpr unsigned size_of(std::uint32_t character) {
  return character < 0x80 ? 1 : character < 0x800 ? 2 : character < 0x10000 ? 3 : 4;
}
}  // namespace

std::optional<std::string> bytes_of(std::uint32_t character) {
  if (!is_character(character)) return std::nullopt;
  const unsigned size = size_of(character);
  if (size == 1) return std::string(1, static_cast<char>(character));
  std::string bytes(1, static_cast<char>((0xf00U >> size & 0xffU) | character >> 6U * (size - 1)));
  for (unsigned rest = size - 1; rest-- > 0;) {
    bytes += static_cast<char>(0x80U | (character >> 6U * rest & 0x3fU));
  }
  return bytes;
}

std::optional<std::string> wide_text(const StoreBytes& store, std::uint32_t ls, std::uint32_t longest) {
  std::string text;
  for (;; ls += 4) {
    if (text.size() >= longest) return text;
    const std::uint32_t character = store.word(ls);
    if (character == 0) return text;
    const auto bytes = bytes_of(character);
    if (!bytes) return std::nullopt;
    if (bytes->size() > longest - text.size()) return text;
    text += *bytes;
  }
}

unsigned bytes_behind(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

std::optional<std::uint32_t> character_of(const std::string& bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  if (bytes.empty() || bytes_behind(byte(0)) != bytes.size()) return std::nullopt;
  if (bytes.size() == 1) return byte(0);
  std::uint32_t character = byte(0) & (0x7fU >> bytes.size());
  for (std::size_t i = 1; i < bytes.size(); ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return std::nullopt;
    character = character << 6U | (byte(i) & 0x3fU);
  }
  // What could be written in fewer bytes is no character either.
  if (!is_character(character) || size_of(character) != bytes.size()) return std::nullopt;
  return character;
}

}  // namespace spu_emu::isa
