#include "host/elf_image.h"

#include <elf.h>

#include <cstring>

namespace spu_emu {

namespace {
template <class Struct>
std::optional<Struct> read_at(std::span<const std::byte> file, std::uint64_t offset) {
  if (offset > file.size() || file.size() - offset < sizeof(Struct)) return std::nullopt;
  Struct value;
  std::memcpy(&value, file.data() + offset, sizeof value);
  return value;
}

/// Sets the size of the module's constructor array to 0 in the dynamic section and remembers where it was.
bool take_constructors(PreparedModule& module, const Elf64_Phdr& dynamic) {
  for (std::uint64_t at = 0; at + sizeof(Elf64_Dyn) <= dynamic.p_filesz; at += sizeof(Elf64_Dyn)) {
    auto entry = read_at<Elf64_Dyn>(module.file, dynamic.p_offset + at);
    if (!entry) return false;
    if (entry->d_tag == DT_NULL) return true;
    if (entry->d_tag == DT_INIT_ARRAY) module.init_array = entry->d_un.d_ptr;
    if (entry->d_tag != DT_INIT_ARRAYSZ) continue;
    module.init_count = entry->d_un.d_val / sizeof(void*);
    entry->d_un.d_val = 0;
    std::memcpy(module.file.data() + dynamic.p_offset + at, &*entry, sizeof *entry);
  }
  return true;
}
}  // namespace

bool is_module(const std::byte* image) {
  Elf64_Ehdr header;
  std::memcpy(&header, image, sizeof header);
  return std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 && header.e_ident[EI_CLASS] == ELFCLASS64 &&
         header.e_ident[EI_DATA] == ELFDATA2LSB && header.e_machine == EM_X86_64 && header.e_type == ET_DYN;
}

std::size_t module_size(const std::byte* image) {
  Elf64_Ehdr header;
  std::memcpy(&header, image, sizeof header);
  return header.e_shoff + std::size_t{header.e_shnum} * header.e_shentsize;
}

std::optional<PreparedModule> prepare_module(std::span<const std::byte> file) {
  const auto header = read_at<Elf64_Ehdr>(file, 0);
  if (!header || !is_module(file.data())) return std::nullopt;
  PreparedModule module;
  module.file.assign(file.begin(), file.end());
  for (std::uint64_t i = 0; i < header->e_phnum; ++i) {
    const auto segment = read_at<Elf64_Phdr>(file, header->e_phoff + i * sizeof(Elf64_Phdr));
    if (!segment) return std::nullopt;
    if (segment->p_type == PT_DYNAMIC && !take_constructors(module, *segment)) return std::nullopt;
  }
  return module;
}

}  // namespace spu_emu
