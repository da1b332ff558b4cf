/// @file
/// The byte order of an SPU, which is big-endian, as the host has to make it.
#ifndef SPU_EMU_MFC_BYTE_ORDER_H
#define SPU_EMU_MFC_BYTE_ORDER_H

#include <bit>
#include <cstdint>

#include "mfc/local_store.h"

namespace spu_emu {

/// Words of the host in the SPU's order, and back.
constexpr std::uint16_t big_endian(std::uint16_t half) {
  return std::endian::native == std::endian::big ? half : __builtin_bswap16(half);
}
constexpr std::uint32_t big_endian(std::uint32_t word) {
  return std::endian::native == std::endian::big ? word : __builtin_bswap32(word);
}

/// How words move between main memory and a local store in the SPU's own order.
constexpr WordOrder kSpuWordOrder =
    std::endian::native == std::endian::big ? WordOrder::same : WordOrder::swapped;

}  // namespace spu_emu

#endif
