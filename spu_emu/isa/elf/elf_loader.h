/// @file
/// Reads SPU ELF files, trusting none of their numbers.
#ifndef SPU_EMU_ISA_ELF_ELF_LOADER_H
#define SPU_EMU_ISA_ELF_ELF_LOADER_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spu_emu::isa {

/// A part of the memory image: `bytes` (of the file) stand at LS address `ls`, zeros follow up to `size`. An
/// overlay is no part of the image at the start: the program fetches it by DMA, to an address that others use
/// too.
struct ElfSegment {
  std::uint32_t ls = 0;
  std::uint32_t size = 0;
  std::span<const std::byte> bytes;
  bool overlay = false;
};

struct ElfSymbol {
  std::uint32_t address = 0;
  std::uint32_t size = 0;
  std::string name;
};

/// A part of the local store.
struct ElfRange {
  std::uint32_t ls = 0;
  std::uint32_t size = 0;
};

/// What a file says, checked. The segments refer to the file's bytes, which must outlive them.
struct ElfProgram {
  std::uint32_t entry = 0;
  /// By rising address; those that are no overlays do not overlap.
  std::vector<ElfSegment> segments;
  /// First LS address behind every segment, overlays included: there the heap begins.
  std::uint32_t end = 0;
  /// By rising address; empty for a stripped file.
  std::vector<ElfSymbol> symbols;
  /// The section .toe, whole quadwords of the local store; empty where there is none.
  ElfRange toe;
  /// The name in the SPU name note, or empty.
  std::string name;
};

/// A program, or one line that says what is wrong with the file and by which numbers.
struct ElfResult {
  std::optional<ElfProgram> program;
  std::string error;
};

/// True when the bytes begin like an ELF file for the SPU.
bool is_spu_elf(std::span<const std::byte> file);

/// Reads a whole file. What it needs to run must be right (header, segments, entry); of symbols and notes it
/// takes what is well formed. Any thread.
ElfResult read_elf(std::span<const std::byte> file);

/// Bytes that an SPU ELF file says it has: the end of its last table or segment. `known` are its first bytes,
/// its header at least; while its segment headers are not among them, the number is where those end.
std::uint64_t claimed_elf_size(std::span<const std::byte> known);

/// The symbol with the highest address up to `address` and the distance, as "name+0x10"; empty if there is
/// none.
std::string nearest_symbol(const std::vector<ElfSymbol>& symbols, std::uint32_t address);

}  // namespace spu_emu::isa

#endif
