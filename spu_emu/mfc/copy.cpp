#include "mfc/copy.h"

#include <cstring>

#include "mfc/command.h"

namespace spu_emu {

namespace {
template <class Unit>
void copy_unit(std::byte* to, const std::byte* from) {
  const Unit value = __atomic_load_n(reinterpret_cast<const Unit*>(from), __ATOMIC_ACQUIRE);
  __atomic_store_n(reinterpret_cast<Unit*>(to), value, __ATOMIC_RELEASE);
}

template <class Unit>
void copy_units(std::byte* to, const std::byte* from, std::size_t size) {
  for (std::size_t done = 0; done < size; done += sizeof(Unit)) copy_unit<Unit>(to + done, from + done);
}

std::size_t widest_unit(const std::byte* to, const std::byte* from, std::size_t size) {
  const std::uintptr_t bits = reinterpret_cast<std::uintptr_t>(to) | reinterpret_cast<std::uintptr_t>(from) |
                              static_cast<std::uintptr_t>(size);
  if (sizeof(void*) == 8 && (bits & 7U) == 0) return 8;
  if ((bits & 3U) == 0) return 4;
  return (bits & 1U) == 0 ? 2 : 1;
}
}  // namespace

void copy_plain(std::byte* to, const std::byte* from, std::size_t size) {
  if (size > kLineSize) {
    std::memcpy(to, from, size);
    return;
  }
  switch (widest_unit(to, from, size)) {
    case 8:
      return copy_units<std::uint64_t>(to, from, size);
    case 4:
      return copy_units<std::uint32_t>(to, from, size);
    case 2:
      return copy_units<std::uint16_t>(to, from, size);
    default:
      return copy_units<std::uint8_t>(to, from, size);
  }
}

void copy_swapping_words(std::byte* to, const std::byte* from, std::size_t size) {
  for (std::size_t done = 0; done < size; done += 4) {
    const auto word = __atomic_load_n(reinterpret_cast<const std::uint32_t*>(from + done), __ATOMIC_ACQUIRE);
    __atomic_store_n(reinterpret_cast<std::uint32_t*>(to + done), __builtin_bswap32(word), __ATOMIC_RELEASE);
  }
}

}  // namespace spu_emu
