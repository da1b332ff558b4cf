#include "libspe2/program_image.h"

#include <elf.h>

#include "host/elf_image.h"
#include "isa/elf/elf_loader.h"

namespace spu_emu {

ImageKind image_kind(const void* image) {
  const auto* bytes = static_cast<const std::byte*>(image);
  if (isa::is_spu_elf({bytes, sizeof(Elf32_Ehdr)})) return ImageKind::spu_elf;
  return is_module(bytes) ? ImageKind::host_module : ImageKind::none;
}

std::size_t image_size(const void* image) {
  const auto* bytes = static_cast<const std::byte*>(image);
  return image_kind(image) == ImageKind::spu_elf ? isa::elf_size_in_memory(bytes) : module_size(bytes);
}

}  // namespace spu_emu
