/// @file
/// Reads bytes of a local store that others may be writing to meanwhile.
#ifndef SPU_EMU_ISA_DEBUG_STORE_READER_H
#define SPU_EMU_ISA_DEBUG_STORE_READER_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace spu_emu::isa {

/// A copy of [first, first + size), which lies inside of the store. A word that a transfer writes is the old
/// or the new one, as for the SPU itself.
inline std::vector<std::byte> read_store(const std::byte* store, std::uint32_t first, std::uint32_t size) {
  std::vector<std::byte> bytes(size);
  std::uint32_t word = 0;
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::uint32_t at = first + i;
    if (i == 0 || at % sizeof word == 0) {
      const auto* whole = reinterpret_cast<const std::uint32_t*>(store + at / sizeof word * sizeof word);
      word = __atomic_load_n(whole, __ATOMIC_RELAXED);
    }
    std::memcpy(&bytes[i], reinterpret_cast<const std::byte*>(&word) + at % sizeof word, 1);
  }
  return bytes;
}

}  // namespace spu_emu::isa

#endif
