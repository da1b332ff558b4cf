/// @file
/// Feeds any bytes to the reader of SPU ELF files.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "isa/elf/elf_loader.h"

namespace {

using spu_emu::isa::ElfProgram;
using spu_emu::isa::ElfSegment;

constexpr std::uint64_t kLocalStore = 0x40000;

void require(bool held) {
  if (!held) std::abort();
}

/// What the loader relies on when it copies.
void check_program(const ElfProgram& program, std::span<const std::byte> file) {
  require(program.entry % 4 == 0 && program.entry < program.end && program.end <= kLocalStore);
  std::uint64_t image_end = 0;
  for (const ElfSegment& segment : program.segments) {
    require(segment.bytes.size() <= segment.size && std::uint64_t{segment.ls} + segment.size <= program.end);
    require(segment.bytes.empty() ||
            (segment.bytes.data() >= file.data() &&
             segment.bytes.data() + segment.bytes.size() <= file.data() + file.size()));
    if (segment.overlay) continue;
    require(segment.ls >= image_end);
    image_end = std::uint64_t{segment.ls} + segment.size;
  }
  for (const std::uint32_t address : {0U, program.entry, program.end, 0xffffffffU}) {
    require(spu_emu::isa::nearest_symbol(program.symbols, address).size() <= file.size() + 16);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = std::as_bytes(std::span(data, size));
  const spu_emu::isa::ElfResult result = spu_emu::isa::read_elf(file);
  require(result.program.has_value() == result.error.empty());
  if (result.program) {
    check_program(*result.program, file);
    require(spu_emu::isa::claimed_elf_size(file) < (std::uint64_t{1} << 34U));
  }
  return 0;
}
