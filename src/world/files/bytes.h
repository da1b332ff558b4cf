/// @file
/// Numbers in files: loads and appends with a stated byte order, the same on a host of either order.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace cellsweep {

enum class ByteOrder { little, big };

/// The unsigned integer whose bytes begin at `bytes[offset]`; the caller has checked that they are all there.
template <std::unsigned_integral Word, ByteOrder order>
constexpr Word load_word(std::span<const std::byte> bytes, std::size_t offset) {
  Word word = 0;
  for (std::size_t i = 0; i < sizeof(Word); ++i) {
    const std::size_t place = order == ByteOrder::little ? i : sizeof(Word) - 1 - i;
    const auto byte = std::to_integer<std::uint64_t>(bytes[offset + i]);
    word = static_cast<Word>(word | (byte << (8 * place)));
  }
  return word;
}

/// The unsigned integer that carries the bits of a 4- or 8-byte number.
template <class Number>
using BitsOf = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;

/// The 4- or 8-byte number that begins at `bytes[offset]`, bit for bit.
template <class Number, ByteOrder order = ByteOrder::little>
constexpr Number load_number(std::span<const std::byte> bytes, std::size_t offset) {
  return std::bit_cast<Number>(load_word<BitsOf<Number>, order>(bytes, offset));
}

/// Adds the bytes of a 4- or 8-byte number, lowest first.
template <class Number>
void append_number(std::vector<std::byte>& bytes, Number number) {
  const auto bits = std::bit_cast<BitsOf<Number>>(number);
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    bytes.push_back(static_cast<std::byte>((bits >> (8 * i)) & 0xff));
  }
}

}  // namespace cellsweep
