/// @file
/// The file of a program with overlays, kept in main memory where the program's overlay manager fetches them
/// by DMA.
#ifndef SPU_EMU_ISA_ELF_OVERLAY_IMAGE_H
#define SPU_EMU_ISA_ELF_OVERLAY_IMAGE_H

#include <memory>
#include <span>

#include "isa/elf/elf_loader.h"

namespace spu_emu::isa {

/// A copy of the file, the bytes of each word swapped where transfers swap them, too, and so make them right
/// again.
class OverlayImage {
 public:
  /// Copies `file` if `program` asks for it: its symbol _EAR_ is the doubleword in the local store at
  /// `local_store` that takes the copy's address. Does nothing otherwise.
  void provide(std::span<const std::byte> file, const ElfProgram& program, std::byte* local_store);

 private:
  struct alignas(128) Line {
    std::byte bytes[128];
  };
  std::unique_ptr<Line[]> lines_;
};

}  // namespace spu_emu::isa

#endif
