#include "lies.h"

#include <elf.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <random>

#include "../isa/elf/elf_builder.h"
#include "isa/elf/elf_format.h"

namespace spu_emu {

namespace {
std::vector<std::uint64_t> lies_for(std::uint64_t file_size) {
  std::vector<std::uint64_t> lies{0, 1, 2, 0x7fff, 0x8000, 0xffff, 0xfffffff0, UINT64_MAX - 15};
  for (const std::uint64_t edge : {file_size, std::uint64_t{0x40000}, std::uint64_t{1} << 31U,
                                   std::uint64_t{1} << 32U, std::uint64_t{1} << 63U, std::uint64_t{0}}) {
    for (const std::uint64_t by : {UINT64_MAX, std::uint64_t{0}, std::uint64_t{1}}) lies.push_back(edge + by);
  }
  return lies;
}

void put_number(FileBytes& file, const Field& field, std::uint64_t value, bool big_endian) {
  for (std::size_t i = 0; i < field.bytes; ++i) {
    const std::size_t shift = 8 * (big_endian ? field.bytes - 1 - i : i);
    file.at(field.at + i) = std::byte(value >> shift);
  }
}

void add_words(std::vector<Field>& fields, std::size_t at, std::size_t count, std::size_t file_size) {
  for (std::size_t i = 0; i < count && at + 4 * i + 4 <= file_size; ++i) fields.push_back({at + 4 * i, 4});
}
}  // namespace

std::vector<Field> fields_of_spu_elf(const FileBytes& file) {
  const Elf32_Ehdr header = isa::elf_header(file.data());
  std::vector<Field> fields{{16, 2}, {18, 2}, {20, 4}, {24, 4}, {28, 4}, {32, 4}, {36, 4},
                            {40, 2}, {42, 2}, {44, 2}, {46, 2}, {48, 2}, {50, 2}};
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    const std::size_t at = header.e_phoff + i * sizeof(Elf32_Phdr);
    add_words(fields, at, sizeof(Elf32_Phdr) / 4, file.size());
    const Elf32_Phdr segment = isa::segment_header(file.data() + at);
    if (segment.p_type == PT_NOTE) add_words(fields, segment.p_offset, 3, file.size());
  }
  for (std::size_t i = 0; i < header.e_shnum; ++i) {
    add_words(fields, header.e_shoff + i * sizeof(Elf32_Shdr), sizeof(Elf32_Shdr) / 4, file.size());
  }
  return fields;
}

std::vector<Field> fields_of_module_header() {
  return {{16, 2}, {18, 2}, {20, 4}, {32, 8}, {40, 8}, {54, 2}, {56, 2}, {58, 2}, {60, 2}};
}

std::vector<Field> fields_of_module(const FileBytes& file) {
  Elf64_Ehdr header;
  std::memcpy(&header, file.data(), sizeof header);
  std::vector<Field> fields = fields_of_module_header();
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    const std::size_t at = header.e_phoff + i * sizeof(Elf64_Phdr);
    for (const std::size_t field : {8U, 16U, 32U, 40U}) fields.push_back({at + field, 8});
  }
  return fields;
}

void for_each_lie(const FileBytes& file, const std::vector<Field>& fields, bool big_endian,
                  const UseFile& use) {
  FileBytes lying = file;
  for (const Field& field : fields) {
    for (const std::uint64_t lie : lies_for(file.size())) {
      put_number(lying, field, lie, big_endian);
      use(lying, "byte " + std::to_string(field.at) + " is " + std::to_string(lie));
    }
    std::copy_n(file.begin() + static_cast<std::ptrdiff_t>(field.at), field.bytes,
                lying.begin() + static_cast<std::ptrdiff_t>(field.at));
  }
}

void for_some_lies(const FileBytes& file, const std::vector<Field>& fields, int count, const UseFile& use) {
  std::mt19937 random(5489);
  for (int i = 0; i < count; ++i) {
    FileBytes lying = file;
    for (unsigned changes = 1 + random() % 3; changes != 0; --changes) {
      const std::uint64_t value = (std::uint64_t{random()} << 32U | random()) >> random() % 64;
      put_number(lying, fields[random() % fields.size()], value, true);
    }
    use(lying, "random file " + std::to_string(i));
  }
}

void for_each_cut(const FileBytes& file, std::size_t step, const UseFile& use) {
  for (std::size_t size = 0; size < file.size(); size += step) {
    use({file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)}, "cut at " + std::to_string(size));
  }
}

GuardedMemory::GuardedMemory(std::size_t most_bytes) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  size_ = (most_bytes + page - 1) / page * page;
  void* given = mmap(nullptr, size_ + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (given == MAP_FAILED) throw std::bad_alloc();
  first_ = static_cast<std::byte*>(given);
  if (mprotect(first_ + size_, page, PROT_NONE) != 0) throw std::bad_alloc();
}

GuardedMemory::~GuardedMemory() {
  munmap(first_, size_ + static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
}

std::span<std::byte> GuardedMemory::put(const FileBytes& file) {
  std::byte* const begin = first_ + size_ - file.size();
  std::copy(file.begin(), file.end(), begin);
  return {begin, file.size()};
}

std::vector<FileBytes> small_spu_programs() {
  using isa::ElfBuilder;
  constexpr std::uint32_t kOverlay = 1U << 27U;
  constexpr std::uint32_t kStop = 0x2017;
  const std::vector<std::uint32_t> note{8,          12,         1,          0x5350554e, 0x414d4500,
                                        0x6b65726e, 0x656c2e65, 0x6c660000, 0};
  FileBytes named = ElfBuilder(0, {{0, {kStop}}, {0, note}}, {{"begin", 0}}).build();
  isa::put_word(named, isa::kFirstSegment + sizeof(Elf32_Phdr), PT_NOTE);
  return {ElfBuilder(0x80, {{0x80, {kStop, 2, 3, 4}}, {0x100, {5}, 64, PF_R | PF_W}},
                     {{"begin", 0x80}, {"middle", 0x88}, {"data", 0x100}})
              .build(),
          std::move(named),
          ElfBuilder(0,
                     {{0, {kStop, 0, 0, 0, 0, 0, 0, 0}},
                      {0x80, {2}, 0, PF_R | PF_X | kOverlay},
                      {0x80, {3, 4}, 0, PF_R | PF_X | kOverlay}},
                     {{"_EAR_", 0x10}})
              .build()};
}

}  // namespace spu_emu
