#include "libspe2/program_image.h"

#include <elf.h>

#include <cstring>

#include "isa/elf/elf_loader.h"

namespace spu_emu {

ImageKind image_kind(const void* image) {
  const auto* bytes = static_cast<const std::byte*>(image);
  if (isa::is_spu_elf({bytes, sizeof(Elf64_Ehdr)})) return ImageKind::spu_elf;
  Elf64_Ehdr header;
  std::memcpy(&header, image, sizeof header);
  const bool host = std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 &&
                    header.e_ident[EI_CLASS] == ELFCLASS64 && header.e_ident[EI_DATA] == ELFDATA2LSB &&
                    header.e_machine == EM_X86_64 && header.e_type == ET_DYN;
  return host ? ImageKind::host_module : ImageKind::none;
}

std::size_t image_size(const void* image) {
  if (image_kind(image) == ImageKind::spu_elf)
    return isa::elf_size_in_memory(static_cast<const std::byte*>(image));
  Elf64_Ehdr header;
  std::memcpy(&header, image, sizeof header);
  return header.e_shoff + std::size_t{header.e_shnum} * header.e_shentsize;
}

}  // namespace spu_emu
