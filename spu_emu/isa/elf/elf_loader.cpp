#include "isa/elf/elf_loader.h"

#include <algorithm>

#include "isa/elf/elf_format.h"
#include "isa/elf/elf_symbols.h"
#include "mfc/command.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {
using Bytes = std::span<const std::byte>;

constexpr std::uint16_t kSpuMachine = 23;
/// Flag of segments that the program itself brings in while it runs.
constexpr std::uint32_t kOverlayFlag = 1U << 27U;

std::string check_header(Bytes file, const Elf32_Ehdr& header) {
  if (header.e_type != ET_EXEC) return format("type %u is not an executable file's", header.e_type);
  if (header.e_version != EV_CURRENT) return format("ELF version %u is not 1", header.e_version);
  if (header.e_phnum == 0) return "it has no segments";
  if (header.e_phentsize != sizeof(Elf32_Phdr)) {
    return format("its segment headers have %u bytes, not 32", header.e_phentsize);
  }
  if (!inside(file, header.e_phoff, std::uint64_t{header.e_phnum} * sizeof(Elf32_Phdr))) {
    return format("its %u segment headers at 0x%x lie outside the %zu bytes of the file", header.e_phnum,
                  header.e_phoff, file.size());
  }
  return {};
}

std::string check_segment(Bytes file, const Elf32_Phdr& header) {
  if (!inside(file, header.p_offset, header.p_filesz)) {
    return format("a segment's %u bytes at 0x%x lie outside the %zu bytes of the file", header.p_filesz,
                  header.p_offset, file.size());
  }
  if (header.p_filesz > header.p_memsz) {
    return format("a segment has %u bytes in the file and only %u in memory", header.p_filesz,
                  header.p_memsz);
  }
  const std::uint64_t end = std::uint64_t{header.p_vaddr} + header.p_memsz;
  if (end > kLocalStoreSize) {
    return format("a segment of %u bytes at LS 0x%x ends at %llu, beyond the %u bytes of the local store",
                  header.p_memsz, header.p_vaddr, static_cast<unsigned long long>(end), kLocalStoreSize);
  }
  return {};
}

std::string check_overlaps(const std::vector<ElfSegment>& segments) {
  const ElfSegment* before = nullptr;
  for (const ElfSegment& segment : segments) {
    if (segment.overlay) continue;
    if (before != nullptr && segment.ls < before->ls + before->size) {
      return format("segments at LS 0x%x and 0x%x overlap", before->ls, segment.ls);
    }
    before = &segment;
  }
  return before == nullptr ? "it has no bytes to load" : std::string{};
}

std::string check_entry(const ElfProgram& program) {
  if (program.entry % 4 != 0) return format("entry 0x%x is no multiple of 4", program.entry);
  const bool loaded = std::any_of(program.segments.begin(), program.segments.end(), [&](const ElfSegment& s) {
    return !s.overlay && program.entry >= s.ls && program.entry - s.ls < s.bytes.size();
  });
  return loaded ? std::string{} : format("entry 0x%x is in no segment of the file", program.entry);
}

/// Adds one segment header's content to the program; what is wrong with it, or nothing.
std::string add_segment(Bytes file, const Elf32_Phdr& header, ElfProgram& program) {
  if (header.p_type == PT_NOTE && inside(file, header.p_offset, header.p_filesz) && program.name.empty()) {
    program.name = read_name_note(file.subspan(header.p_offset, header.p_filesz));
  }
  if (header.p_type != PT_LOAD || header.p_memsz == 0) return {};
  std::string error = check_segment(file, header);
  if (!error.empty()) return error;
  program.segments.push_back({header.p_vaddr, header.p_memsz, file.subspan(header.p_offset, header.p_filesz),
                              (header.p_flags & kOverlayFlag) != 0});
  program.end = std::max(program.end, header.p_vaddr + header.p_memsz);
  return {};
}

std::string read_segments(Bytes file, const Elf32_Ehdr& header, ElfProgram& program) {
  std::string error = check_header(file, header);
  if (!error.empty()) return error;
  for (std::uint32_t i = 0; i < header.e_phnum; ++i) {
    const auto segment = segment_header(file.data() + header.e_phoff + i * sizeof(Elf32_Phdr));
    error = add_segment(file, segment, program);
    if (!error.empty()) return error;
  }
  std::stable_sort(program.segments.begin(), program.segments.end(),
                   [](const ElfSegment& a, const ElfSegment& b) { return a.ls < b.ls; });
  error = check_overlaps(program.segments);
  return error.empty() ? check_entry(program) : error;
}
}  // namespace

bool is_spu_elf(Bytes file) {
  if (file.size() < sizeof(Elf32_Ehdr)) return false;
  const Elf32_Ehdr header = elf_header(file.data());
  return std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 && header.e_ident[EI_CLASS] == ELFCLASS32 &&
         header.e_ident[EI_DATA] == ELFDATA2MSB && header.e_machine == kSpuMachine;
}

ElfResult read_elf(Bytes file) {
  if (!is_spu_elf(file))
    return {std::nullopt, "not an SPU program: it is no 32-bit big-endian ELF file for the SPU"};
  const Elf32_Ehdr header = elf_header(file.data());
  ElfProgram program;
  program.entry = header.e_entry;
  const std::string error = read_segments(file, header, program);
  if (!error.empty()) return {std::nullopt, "broken SPU program: " + error};
  program.symbols = read_symbols(file, header);
  program.toe = read_toe(file, header);
  return {std::move(program), {}};
}

std::uint64_t claimed_elf_size(Bytes known) {
  const Elf32_Ehdr header = elf_header(known.data());
  const std::uint64_t segment_bytes = std::uint64_t{header.e_phnum} * header.e_phentsize;
  std::uint64_t end = sizeof(Elf32_Ehdr);
  end = std::max(end, header.e_shoff + std::uint64_t{header.e_shnum} * header.e_shentsize);
  end = std::max(end, header.e_phoff + segment_bytes);
  if (header.e_phentsize != sizeof(Elf32_Phdr) || !inside(known, header.e_phoff, segment_bytes)) return end;
  for (std::uint32_t i = 0; i < header.e_phnum; ++i) {
    const auto segment = segment_header(known.data() + header.e_phoff + i * sizeof(Elf32_Phdr));
    end = std::max(end, std::uint64_t{segment.p_offset} + segment.p_filesz);
  }
  return end;
}

}  // namespace spu_emu::isa
