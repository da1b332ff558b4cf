/// @file
/// Copies between a local store and main memory, plain or with every 32-bit word swapped.
#ifndef SPU_EMU_MFC_COPY_H
#define SPU_EMU_MFC_COPY_H

#include <cstddef>
#include <cstdint>

#include "mfc/local_store.h"

namespace spu_emu {

/// Copies `size` bytes. Up to 128 bytes move in the widest aligned units up to 8 bytes, each read with
/// acquire and written with release order: a flag put by one SPE can be polled by another thread as
/// std::atomic, and bytes that went before it are then visible. More than 128 bytes move by memcpy, without
/// any atomicity.
void copy_plain(std::byte* to, const std::byte* from, std::size_t size);

/// Copies with the bytes of each 32-bit word swapped; size and both addresses are multiples of 4. Words are
/// atomic as in copy_plain.
void copy_swapping_words(std::byte* to, const std::byte* from, std::size_t size);

inline void copy_bytes(std::byte* to, const std::byte* from, std::size_t size, WordOrder order) {
  if (order == WordOrder::same) {
    copy_plain(to, from, size);
  } else {
    copy_swapping_words(to, from, size);
  }
}

}  // namespace spu_emu

#endif
