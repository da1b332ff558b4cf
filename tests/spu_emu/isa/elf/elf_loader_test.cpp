// SPU ELF files: what is read from good ones, and that every broken field is refused with a reason.
#include "isa/elf/elf_loader.h"

#include <gtest/gtest.h>

#include "elf_builder.h"

namespace spu_emu::isa {
namespace {

File small_program() {
  return ElfBuilder(0x84, {{0x80, {1, 2, 3, 4}}, {0x100, {5}, 64, PF_R | PF_W}},
                    {{"start", 0x80}, {"middle", 0x88}, {"data", 0x100}})
      .build();
}

std::string error_of(const File& file) {
  return read_elf(file).error;
}

void expect_error(const File& file, const char* part) {
  EXPECT_FALSE(read_elf(file).program.has_value());
  EXPECT_NE(error_of(file).find(part), std::string::npos) << part << " is not in: " << error_of(file);
}

TEST(ElfLoader, reads_entry_segments_and_the_end_of_the_image) {
  const File file = small_program();
  const ElfResult result = read_elf(file);
  ASSERT_TRUE(result.program.has_value()) << result.error;
  EXPECT_EQ(result.program->entry, 0x84U);
  EXPECT_EQ(result.program->end, 0x140U);
  ASSERT_EQ(result.program->segments.size(), 2U);
  EXPECT_EQ(result.program->segments[0].bytes.size(), 16U);
  EXPECT_EQ(read_word(result.program->segments[0].bytes.data() + 4), 2U);
  EXPECT_EQ(result.program->segments[1].size, 64U);
  EXPECT_EQ(claimed_elf_size(file), file.size());
}

TEST(ElfLoader, names_the_nearest_symbol) {
  const File file = small_program();
  const auto symbols = read_elf(file).program->symbols;
  EXPECT_EQ(nearest_symbol(symbols, 0x80), "start");
  EXPECT_EQ(nearest_symbol(symbols, 0x84), "start+0x4");
  EXPECT_EQ(nearest_symbol(symbols, 0x90), "middle+0x8");
  EXPECT_EQ(nearest_symbol(symbols, 0x10), "");
  EXPECT_EQ(nearest_symbol({}, 0x80), "");
}

TEST(ElfLoader, reads_the_name_note) {
  File file =
      ElfBuilder(0, {{0, {1}}, {0, {8, 12, 1, 0x5350554e, 0x414d4500, 0x6b65726e, 0x656c2e65, 0x6c660000}}})
          .build();
  put_word(file, kFirstSegment + sizeof(Elf32_Phdr), PT_NOTE);
  const ElfResult result = read_elf(file);
  ASSERT_TRUE(result.program.has_value()) << result.error;
  EXPECT_EQ(result.program->name, "kernel.elf");
}

TEST(ElfLoader, every_broken_field_of_the_header_is_refused) {
  const auto with_half = [](std::size_t at, std::uint16_t value) {
    File file = small_program();
    put_half(file, at, value);
    return file;
  };
  const auto with_word = [](std::size_t at, std::uint32_t value) {
    File file = small_program();
    put_word(file, at, value);
    return file;
  };
  expect_error({}, "not an SPU program");
  expect_error(with_word(0, 0), "not an SPU program");
  expect_error(with_half(4, 0x0202), "not an SPU program");
  expect_error(with_half(4, 0x0101), "not an SPU program");
  expect_error(with_half(kMachineAt, EM_X86_64), "not an SPU program");
  expect_error(with_half(kTypeAt, ET_REL), "type 1");
  expect_error(with_word(kVersionAt, 2), "version 2");
  expect_error(with_half(kSegmentCountAt, 0), "no segments");
  expect_error(with_half(kSegmentCountAt, 0xffff), "65535 segment headers");
  expect_error(with_half(kSegmentHeaderSizeAt, 56), "56 bytes");
  expect_error(with_word(kSegmentTableAt, 0xfffffff0), "outside");
  expect_error(with_word(kEntryAt, 0x86), "multiple of 4");
  expect_error(with_word(kEntryAt, 0x90), "in no segment");
  expect_error(with_word(kEntryAt, 0x104), "in no segment");
}

TEST(ElfLoader, every_broken_field_of_a_segment_is_refused) {
  const auto with_word = [](std::size_t at, std::uint32_t value) {
    File file = small_program();
    put_word(file, at, value);
    return file;
  };
  expect_error(with_word(kSegmentOffsetAt, 0xfffffffc), "outside");
  expect_error(with_word(kSegmentFileSizeAt, 0xffffffff), "outside");
  expect_error(with_word(kSegmentMemorySizeAt, 12), "only 12 in memory");
  expect_error(with_word(kSegmentAddressAt, 0x40000 - 8), "beyond the 262144");
  expect_error(with_word(kSegmentAddressAt, 0xffffffff), "beyond the 262144");
  expect_error(with_word(kSegmentMemorySizeAt, 0x40001), "262145 bytes");
  expect_error(with_word(kSegmentMemorySizeAt, 0x84), "0x80 and 0x100 overlap");
  expect_error(with_word(kFirstSegment, PT_NULL), "in no segment");
}

TEST(ElfLoader, a_file_that_loads_nothing_is_refused) {
  File file = ElfBuilder(0, {{0, {1}}}).build();
  put_word(file, kFirstSegment, PT_NOTE);
  expect_error(file, "no bytes to load");
}

TEST(ElfLoader, overlays_may_share_an_address_and_are_not_part_of_the_image) {
  constexpr std::uint32_t kOverlay = 1U << 27U;
  const File file =
      ElfBuilder(
          0, {{0, {1}}, {0x80, {2}, 0, PF_R | PF_X | kOverlay}, {0x80, {3, 4}, 0, PF_R | PF_X | kOverlay}})
          .build();
  const ElfResult result = read_elf(file);
  ASSERT_TRUE(result.program.has_value()) << result.error;
  EXPECT_FALSE(result.program->segments[0].overlay);
  EXPECT_TRUE(result.program->segments[2].overlay);
  EXPECT_EQ(result.program->end, 0x88U);
}

TEST(ElfLoader, broken_symbols_and_notes_are_left_out) {
  const File good = small_program();
  for (std::size_t at = good.size() - 3 * sizeof(Elf32_Shdr); at < good.size(); ++at) {
    File file = good;
    file[at] = std::byte{0xff};
    EXPECT_TRUE(read_elf(file).program.has_value()) << "byte " << at;
  }
}

TEST(ElfLoader, no_truncated_file_leads_outside_it) {
  const File good = small_program();
  for (std::size_t size = 0; size < good.size(); ++size) {
    const File cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
    const ElfResult result = read_elf(cut);
    EXPECT_NE(result.program.has_value(), !result.error.empty());
  }
}

}  // namespace
}  // namespace spu_emu::isa
