/// @file
/// Words of the SPU's byte order, read from and written to bytes at any address.
#ifndef SPU_EMU_ISA_ENCODING_BIG_ENDIAN_H
#define SPU_EMU_ISA_ENCODING_BIG_ENDIAN_H

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "mfc/byte_order.h"

namespace spu_emu::isa {

inline std::uint16_t read_half(const std::byte* at) {
  std::uint16_t value = 0;
  std::memcpy(&value, at, sizeof value);
  return big_endian(value);
}

inline std::uint32_t read_word(const std::byte* at) {
  std::uint32_t value = 0;
  std::memcpy(&value, at, sizeof value);
  return big_endian(value);
}

inline std::uint64_t read_doubleword(const std::byte* at) {
  return (std::uint64_t{read_word(at)} << 32U) | read_word(at + 4);
}

inline void write_word(std::byte* at, std::uint32_t value) {
  value = big_endian(value);
  std::memcpy(at, &value, sizeof value);
}

inline void write_doubleword(std::byte* at, std::uint64_t value) {
  write_word(at, static_cast<std::uint32_t>(value >> 32U));
  write_word(at + 4, static_cast<std::uint32_t>(value));
}

}  // namespace spu_emu::isa

#endif
