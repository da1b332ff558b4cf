/// @file
/// Tables for instructions that move bytes of a register by a count or an address: pshufb controls and masks,
/// for registers kept as four host words.
#ifndef SPU_EMU_ISA_CORE_BYTE_TABLES_H
#define SPU_EMU_ISA_CORE_BYTE_TABLES_H

#include <array>
#include <cstdint>

#include "spu_emu/intrinsics/qword.h"

namespace spu_emu::isa {

struct alignas(16) Bytes {
  std::array<std::uint8_t, 16> bytes;

  qword words() const { return static_cast<qword>(vector()); }
  vec_uint4 vector() const { return *reinterpret_cast<const vec_uint4*>(bytes.data()); }
};

/// Where byte `k` of the SPU's register lies in the host's words, and back.
constexpr unsigned host_byte(unsigned k) {
  return detail::is_big_endian ? k : k ^ 3U;
}

/// Controls by count, made of from(k, count): the SPU byte that byte k becomes, or 16 and above for zero.
template <std::size_t Count, typename From>
constexpr std::array<Bytes, Count> make_controls(From from) {
  std::array<Bytes, Count> controls{};
  for (unsigned count = 0; count < Count; ++count)
    for (unsigned k = 0; k < 16; ++k) {
      const unsigned source = from(k, count);
      controls[count].bytes[host_byte(k)] = static_cast<std::uint8_t>(source < 16 ? host_byte(source) : 0x80);
    }
  return controls;
}

/// The mask by which shufb inserts `width` bytes of a preferred slot at an address, for its 16 offsets.
constexpr std::array<Bytes, 16> make_insertions(unsigned width) {
  std::array<Bytes, 16> masks{};
  const unsigned first = width < 4 ? 4 - width : 0;
  for (unsigned offset = 0; offset < 16; ++offset) {
    const unsigned start = offset & ~(width - 1);
    for (unsigned k = 0; k < 16; ++k) {
      const bool inserted = k >= start && k < start + width;
      masks[offset].bytes[host_byte(k)] = static_cast<std::uint8_t>(inserted ? first + k - start : 16 + k);
    }
  }
  return masks;
}

}  // namespace spu_emu::isa

#endif
