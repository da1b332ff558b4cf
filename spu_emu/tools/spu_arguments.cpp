#include "tools/spu_arguments.h"

#include <algorithm>
#include <stdexcept>

#include "isa/elf/elf_loader.h"
#include "isa/encoding/big_endian.h"
#include "mfc/command.h"
#include "spu_emu/channel_numbers.h"

namespace spu_emu {

namespace {
using isa::read_word;
using isa::write_word;

constexpr std::uint32_t kStartUpWords = 32;

bool issues_dma_command(std::uint32_t word) {
  constexpr std::uint32_t kWriteChannel = 0x10d;
  return word >> 21U == kWriteChannel && ((word >> 7U) & 0x7fU) == MFC_Cmd;
}

std::uint32_t rounded_up(std::size_t size) {
  return static_cast<std::uint32_t>((size + 15) / 16 * 16);
}

void append(std::vector<std::byte>& bytes, const std::string& text) {
  const auto all = std::as_bytes(std::span(text.c_str(), text.size() + 1));
  bytes.insert(bytes.end(), all.begin(), all.end());
}

/// Pointers and a null, then the texts; the pointers hold when the region lies below `top`.
std::vector<std::byte> argument_region(const std::vector<std::string>& arguments, std::uint32_t top) {
  std::vector<std::byte> texts;
  std::vector<std::size_t> offsets;
  for (const std::string& argument : arguments) {
    offsets.push_back(texts.size());
    append(texts, argument);
  }
  const std::size_t pointers = 4 * (arguments.size() + 1);
  std::vector<std::byte> region(pointers);
  region.insert(region.end(), texts.begin(), texts.end());
  region.resize(rounded_up(region.size()));
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    write_word(region.data() + 4 * i,
               static_cast<std::uint32_t>(top - region.size() + pointers + offsets[i]));
  }
  return region;
}
}  // namespace

MainKind main_kind(std::span<const std::byte> elf_file) {
  const isa::ElfResult elf = isa::read_elf(elf_file);
  if (!elf.program) return MainKind::spe;
  for (const isa::ElfSegment& segment : elf.program->segments) {
    const std::uint32_t offset = elf.program->entry - segment.ls;
    if (segment.overlay || elf.program->entry < segment.ls || offset >= segment.bytes.size()) continue;
    const auto code = segment.bytes.subspan(offset);
    for (std::uint32_t at = 0; at < 4 * kStartUpWords && at + 4 <= code.size(); at += 4) {
      if (issues_dma_command(read_word(code.data() + at))) return MainKind::standard;
    }
  }
  return MainKind::spe;
}

SpuArguments::SpuArguments(MainKind kind, const std::vector<std::string>& arguments,
                           std::uint32_t local_store_size) {
  std::vector<std::byte> bytes;
  if (kind == MainKind::standard) {
    bytes = argument_region(arguments, local_store_size);
  } else {
    for (const std::string& argument : arguments) append(bytes, argument);
    bytes.resize(rounded_up(bytes.size()));
  }
  const auto size = static_cast<std::uint32_t>(bytes.size());
  if (size > kLargestTransfer) throw std::length_error("the arguments have more than 16384 bytes");
  const std::uint64_t address = keep(bytes);
  const auto high = static_cast<std::uint32_t>(address >> 32U);
  const auto low = static_cast<std::uint32_t>(address);
  if (kind == MainKind::standard) {
    registers_ = {
        static_cast<std::uint32_t>(arguments.size()), 0, 0, 0, local_store_size - size, high, low, size};
  } else {
    registers_ = {0, 1, 0, 0, high, low, 0, 0, 0, size};
  }
}

/// In memory the words have this machine's order: DMA swaps them.
std::uint64_t SpuArguments::keep(std::span<const std::byte> bytes) {
  for (std::size_t i = 0; i < bytes.size() / 4; ++i) memory_.words()[i] = read_word(bytes.data() + 4 * i);
  return reinterpret_cast<std::uintptr_t>(memory_.words());
}

}  // namespace spu_emu
