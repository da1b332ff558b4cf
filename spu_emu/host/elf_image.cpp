#include "host/elf_image.h"

#include <elf.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "mfc/format.h"

namespace spu_emu {

namespace {
/// All of a module's segments together; more addresses than this are not asked of the system.
constexpr std::uint64_t kMostModuleBytes = std::uint64_t{1} << 31U;

bool is_inside(std::uint64_t offset, std::uint64_t size, std::uint64_t whole) {
  return offset <= whole && size <= whole - offset;
}

/// The sum, or the largest number there is.
std::uint64_t end_of(std::uint64_t offset, std::uint64_t size) {
  std::uint64_t end = 0;
  return __builtin_add_overflow(offset, size, &end) ? UINT64_MAX : end;
}

template <class Struct>
std::optional<Struct> read_at(std::span<const std::byte> file, std::uint64_t offset) {
  if (!is_inside(offset, sizeof(Struct), file.size())) return std::nullopt;
  Struct value;
  std::memcpy(&value, file.data() + offset, sizeof value);
  return value;
}

using Segments = std::vector<Elf64_Phdr>;

unsigned long long number(std::uint64_t value) {
  return value;
}

/// Reads the segment headers; what is wrong with the file's header, or nothing.
std::string read_segment_headers(std::span<const std::byte> file, Segments& segments) {
  const auto header = read_at<Elf64_Ehdr>(file, 0);
  if (!header || !is_module(file)) return "the image is no x86-64 program module";
  if (header->e_phentsize != sizeof(Elf64_Phdr)) {
    return format("its segment headers have %u bytes, not %zu", header->e_phentsize, sizeof(Elf64_Phdr));
  }
  const std::uint64_t bytes = std::uint64_t{header->e_phnum} * sizeof(Elf64_Phdr);
  if (!is_inside(header->e_phoff, bytes, file.size())) {
    return format("its %u segment headers at 0x%llx lie outside the %zu bytes of the file", header->e_phnum,
                  number(header->e_phoff), file.size());
  }
  for (std::uint64_t i = 0; i < header->e_phnum; ++i) {
    segments.push_back(*read_at<Elf64_Phdr>(file, header->e_phoff + i * sizeof(Elf64_Phdr)));
  }
  return {};
}

/// The dynamic linker maps loaded segments at their addresses, one after the other, and believes that they
/// are in the file and in order.
std::string check_loaded_segments(std::span<const std::byte> file, const Segments& segments) {
  std::uint64_t before = 0;
  for (const Elf64_Phdr& segment : segments) {
    if (segment.p_type != PT_LOAD) continue;
    if (!is_inside(segment.p_offset, segment.p_filesz, file.size())) {
      return format("a segment's %llu bytes at 0x%llx lie outside the %zu bytes of the file",
                    number(segment.p_filesz), number(segment.p_offset), file.size());
    }
    if (segment.p_filesz > segment.p_memsz) {
      return format("a segment has %llu bytes in the file and only %llu in memory", number(segment.p_filesz),
                    number(segment.p_memsz));
    }
    if (segment.p_vaddr < before || !is_inside(segment.p_vaddr, segment.p_memsz, kMostModuleBytes)) {
      return format("a segment of %llu bytes at address 0x%llx overlaps the one before or ends beyond %llu",
                    number(segment.p_memsz), number(segment.p_vaddr), number(kMostModuleBytes));
    }
    before = segment.p_vaddr + segment.p_memsz;
  }
  return before == 0 ? "it has no bytes to load" : std::string{};
}

/// Whether a loaded segment holds these addresses; with `in_file`, as bytes of the file that are at the
/// offset that `part` says.
bool is_loaded(const Segments& segments, const Elf64_Phdr& part, bool in_file) {
  return std::any_of(segments.begin(), segments.end(), [&](const Elf64_Phdr& load) {
    if (load.p_type != PT_LOAD || part.p_vaddr < load.p_vaddr) return false;
    const std::uint64_t offset = part.p_vaddr - load.p_vaddr;
    if (!in_file) return is_inside(offset, part.p_memsz, load.p_memsz);
    return is_inside(offset, part.p_filesz, load.p_filesz) && part.p_offset - load.p_offset == offset;
  });
}

/// Other segments name parts of the loaded ones; the dynamic linker reads and protects what they name.
/// Uninitialised data of threads has no memory there.
std::string check_other_segments(const Segments& segments) {
  for (const Elf64_Phdr& segment : segments) {
    if (segment.p_type == PT_LOAD || segment.p_type == PT_GNU_STACK || segment.p_type == PT_NULL) continue;
    const bool in_file = segment.p_type == PT_DYNAMIC || segment.p_type == PT_TLS;
    if (segment.p_type == PT_TLS && segment.p_filesz == 0 && segment.p_memsz < kMostModuleBytes) continue;
    if (!is_loaded(segments, segment, in_file)) {
      return format("a segment of type 0x%x, %llu bytes at address 0x%llx, lies in no loaded one",
                    segment.p_type, number(segment.p_memsz), number(segment.p_vaddr));
    }
  }
  return {};
}

/// Notes where the module's constructors are, and where the dynamic section says how many. False if the
/// section has no end.
bool take_constructors(std::span<const std::byte> file, const Elf64_Phdr& dynamic, PreparedModule& module) {
  for (std::uint64_t at = 0; at + sizeof(Elf64_Dyn) <= dynamic.p_filesz; at += sizeof(Elf64_Dyn)) {
    const auto entry = read_at<Elf64_Dyn>(file, dynamic.p_offset + at);
    if (!entry) return false;
    if (entry->d_tag == DT_NULL) return true;
    if (entry->d_tag == DT_INIT_ARRAY) module.init_array = entry->d_un.d_ptr;
    if (entry->d_tag != DT_INIT_ARRAYSZ) continue;
    module.init_count = entry->d_un.d_val / sizeof(void*);
    module.zero_words.push_back(dynamic.p_offset + at + offsetof(Elf64_Dyn, d_un));
  }
  return false;
}

std::string check_constructors(const PreparedModule& module, const Segments& segments) {
  if (module.init_count == 0) return {};
  Elf64_Phdr array{};
  array.p_vaddr = module.init_array;
  array.p_memsz = module.init_count * sizeof(void*);
  if (module.init_array % sizeof(void*) == 0 && is_loaded(segments, array, false)) return {};
  return format("its %llu constructors at address 0x%llx lie in no loaded segment", number(module.init_count),
                number(module.init_array));
}

std::string check_segments(std::span<const std::byte> file, const Segments& segments) {
  std::string error = check_loaded_segments(file, segments);
  return error.empty() ? check_other_segments(segments) : error;
}
}  // namespace

bool is_module(std::span<const std::byte> image) {
  const auto header = read_at<Elf64_Ehdr>(image, 0);
  return header && std::memcmp(header->e_ident, ELFMAG, SELFMAG) == 0 &&
         header->e_ident[EI_CLASS] == ELFCLASS64 && header->e_ident[EI_DATA] == ELFDATA2LSB &&
         header->e_machine == EM_X86_64 && header->e_type == ET_DYN;
}

std::uint64_t claimed_module_size(std::span<const std::byte> known) {
  const auto header = read_at<Elf64_Ehdr>(known, 0);
  if (!header) return sizeof(Elf64_Ehdr);
  const std::uint64_t segment_bytes = std::uint64_t{header->e_phnum} * header->e_phentsize;
  std::uint64_t end = sizeof(Elf64_Ehdr);
  end = std::max(end, end_of(header->e_shoff, std::uint64_t{header->e_shnum} * header->e_shentsize));
  end = std::max(end, end_of(header->e_phoff, segment_bytes));
  Segments segments;
  if (end == UINT64_MAX || !read_segment_headers(known, segments).empty()) return end;
  for (const Elf64_Phdr& segment : segments) end = std::max(end, end_of(segment.p_offset, segment.p_filesz));
  return end;
}

std::optional<PreparedModule> prepare_module(std::span<const std::byte> file, std::string& error) {
  Segments segments;
  error = read_segment_headers(file, segments);
  if (error.empty()) error = check_segments(file, segments);
  if (!error.empty()) return std::nullopt;
  PreparedModule module;
  for (const Elf64_Phdr& segment : segments) {
    if (segment.p_type == PT_DYNAMIC && !take_constructors(file, segment, module)) {
      error = format("its dynamic section of %llu bytes has no end", number(segment.p_filesz));
      return std::nullopt;
    }
  }
  error = check_constructors(module, segments);
  if (!error.empty()) return std::nullopt;
  return module;
}

}  // namespace spu_emu
