// Small SPU ELF files made by hand, whole or broken.
#ifndef SPU_EMU_TESTS_ISA_ELF_ELF_BUILDER_H
#define SPU_EMU_TESTS_ISA_ELF_ELF_BUILDER_H

#include <elf.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "isa/encoding/big_endian.h"

namespace spu_emu::isa {

using File = std::vector<std::byte>;

struct TestSegment {
  std::uint32_t ls = 0;
  std::vector<std::uint32_t> words;
  /// Bytes in memory; 0: as many as in the file.
  std::uint32_t memory_size = 0;
  std::uint32_t flags = PF_R | PF_X;
};

struct TestSymbol {
  std::string name;
  std::uint32_t address = 0;
};

/// Byte offsets of fields, for tests that break them.
inline constexpr std::size_t kTypeAt = 16;
inline constexpr std::size_t kMachineAt = 18;
inline constexpr std::size_t kVersionAt = 20;
inline constexpr std::size_t kEntryAt = 24;
inline constexpr std::size_t kSegmentTableAt = 28;
inline constexpr std::size_t kSegmentHeaderSizeAt = 42;
inline constexpr std::size_t kSegmentCountAt = 44;
/// Of the first segment's header.
inline constexpr std::size_t kFirstSegment = sizeof(Elf32_Ehdr);
inline constexpr std::size_t kSegmentOffsetAt = kFirstSegment + 4;
inline constexpr std::size_t kSegmentAddressAt = kFirstSegment + 8;
inline constexpr std::size_t kSegmentFileSizeAt = kFirstSegment + 16;
inline constexpr std::size_t kSegmentMemorySizeAt = kFirstSegment + 20;

inline void put_half(File& file, std::size_t at, std::uint16_t value) {
  file.at(at) = std::byte(value >> 8U);
  file.at(at + 1) = std::byte(value & 0xffU);
}
inline void put_word(File& file, std::size_t at, std::uint32_t value) {
  write_word(std::span(file).subspan(at, 4).data(), value);
}

/// Header, segment headers, segments, and with symbols a section table with a symbol and a string table.
class ElfBuilder {
 public:
  ElfBuilder(std::uint32_t entry, std::vector<TestSegment> segments, std::vector<TestSymbol> symbols = {})
      : entry_(entry), segments_(std::move(segments)), symbols_(std::move(symbols)) {}

  /// Adds a section .toe, which has no bytes in the file; only with symbols.
  ElfBuilder& with_toe(std::uint32_t address, std::uint32_t size) {
    toe_ = {address, {}, size};
    return *this;
  }

  File build() {
    header();
    for (std::size_t i = 0; i < segments_.size(); ++i) segment(i);
    if (!symbols_.empty()) symbol_sections();
    return std::move(file_);
  }

 private:
  void header() {
    file_.resize(sizeof(Elf32_Ehdr) + segments_.size() * sizeof(Elf32_Phdr));
    const unsigned char ident[] = {0x7f, 'E', 'L', 'F', ELFCLASS32, ELFDATA2MSB, EV_CURRENT};
    std::memcpy(file_.data(), ident, sizeof ident);
    put_half(file_, kTypeAt, ET_EXEC);
    put_half(file_, kMachineAt, 23);
    put_word(file_, kVersionAt, EV_CURRENT);
    put_word(file_, kEntryAt, entry_);
    put_word(file_, kSegmentTableAt, sizeof(Elf32_Ehdr));
    put_half(file_, 40, sizeof(Elf32_Ehdr));
    put_half(file_, kSegmentHeaderSizeAt, sizeof(Elf32_Phdr));
    put_half(file_, kSegmentCountAt, static_cast<std::uint16_t>(segments_.size()));
    put_half(file_, 46, sizeof(Elf32_Shdr));
  }

  void segment(std::size_t index) {
    const TestSegment& segment = segments_[index];
    const auto size = static_cast<std::uint32_t>(4 * segment.words.size());
    const std::size_t at = sizeof(Elf32_Ehdr) + index * sizeof(Elf32_Phdr);
    put_word(file_, at, PT_LOAD);
    put_word(file_, at + 4, static_cast<std::uint32_t>(file_.size()));
    put_word(file_, at + 8, segment.ls);
    put_word(file_, at + 16, size);
    put_word(file_, at + 20, segment.memory_size == 0 ? size : segment.memory_size);
    put_word(file_, at + 24, segment.flags);
    for (const std::uint32_t word : segment.words) append_word(word);
  }

  void append_word(std::uint32_t word) {
    file_.resize(file_.size() + 4);
    put_word(file_, file_.size() - 4, word);
  }

  void symbol_sections() {
    std::string names(1, '\0');
    const auto symbols_at = static_cast<std::uint32_t>(file_.size());
    for (const TestSymbol& symbol : symbols_) {
      append_word(static_cast<std::uint32_t>(names.size()));
      append_word(symbol.address);
      append_word(0);
      append_word((std::uint32_t{ELF32_ST_INFO(STB_GLOBAL, STT_FUNC)} << 24U) | 1U);
      names += symbol.name + '\0';
    }
    const auto toe_name = static_cast<std::uint32_t>(names.size());
    names += std::string(".toe") + '\0';
    const auto names_at = static_cast<std::uint32_t>(file_.size());
    for (const char c : names) file_.push_back(std::byte(c));
    const auto table_at = static_cast<std::uint32_t>(file_.size());
    put_word(file_, 32, table_at);
    put_half(file_, 48, 4);
    put_half(file_, 50, 2);
    section(SHT_NULL, 0, 0, 0);
    section(SHT_SYMTAB, symbols_at, names_at - symbols_at, 2);
    section(SHT_STRTAB, names_at, static_cast<std::uint32_t>(names.size()), 0);
    const std::uint32_t toe_type = toe_.memory_size == 0 ? SHT_NULL : SHT_NOBITS;
    section(toe_type, 0, toe_.memory_size, 0, toe_name, toe_.ls);
  }

  void section(std::uint32_t type, std::uint32_t offset, std::uint32_t size, std::uint32_t link,
               std::uint32_t name = 0, std::uint32_t address = 0) {
    for (const std::uint32_t word : {name, type, 0U, address, offset, size, link, 0U, 1U, 16U})
      append_word(word);
  }

  std::uint32_t entry_;
  std::vector<TestSegment> segments_;
  std::vector<TestSymbol> symbols_;
  TestSegment toe_;
  File file_;
};

}  // namespace spu_emu::isa

#endif
