#include "isa/elf/effective_addresses.h"

#include <cstring>

#include "isa/encoding/big_endian.h"
#include "mfc/format.h"
#include "mfc/mapped.h"

namespace spu_emu::isa {

std::string place_effective_addresses(const ElfRange& toe, const void* shadow, std::byte* local_store) {
  constexpr std::uint32_t kQuadword = 16;
  if (shadow == nullptr || toe.size == 0) return {};
  if (!is_mapped(reinterpret_cast<std::uintptr_t>(shadow), toe.size, Access::read)) {
    return format(
        "broken handle: the %u bytes of toe_shadow at %p, for the program's section .toe, cannot be read",
        toe.size, shadow);
  }
  for (std::uint32_t at = 0; at < toe.size; at += kQuadword) {
    std::uint64_t address = 0;
    std::memcpy(&address, static_cast<const std::byte*>(shadow) + at, sizeof address);
    write_doubleword(local_store + toe.ls + at, address);
  }
  return {};
}

}  // namespace spu_emu::isa
