#include "isa/elf/overlay_image.h"

#include <algorithm>
#include <cstring>

#include "isa/encoding/big_endian.h"
#include "mfc/byte_order.h"
#include "mfc/command.h"

namespace spu_emu::isa {

void OverlayImage::provide(std::span<const std::byte> file, const ElfProgram& program,
                           std::byte* local_store) {
  const auto address = std::find_if(program.symbols.begin(), program.symbols.end(),
                                    [](const ElfSymbol& symbol) { return symbol.name == "_EAR_"; });
  if (address == program.symbols.end() || address->address > kLocalStoreSize - 8) return;
  lines_ = std::make_unique<Line[]>(file.size() / sizeof(Line) + 1);
  auto* copy = reinterpret_cast<std::byte*>(lines_.get());
  std::memcpy(copy, file.data(), file.size());
  if (kSpuWordOrder == WordOrder::swapped) {
    for (std::size_t at = 0; at < file.size(); at += 4) std::reverse(copy + at, copy + at + 4);
  }
  write_doubleword(local_store + address->address, reinterpret_cast<std::uintptr_t>(copy));
}

}  // namespace spu_emu::isa
