// The second handle that add_spu_program defines where the real compiler is.
#include <gtest/gtest.h>
#include <libspe2.h>

#include <string_view>

#include "libspe2/program_image.h"

#ifndef SPU_EMU_HAS_ELF
#error "a library with an ELF program says so to its users"
#endif

extern "C" spe_program_handle_t list_gather_spu;
extern "C" spe_program_handle_t list_gather_spu_elf;

namespace spu_emu {
namespace {

// A 32-bit ELF header says where the section headers are, which come last, in big-endian order.
std::string_view image_of(const spe_program_handle_t& handle) {
  const auto* bytes = static_cast<const unsigned char*>(handle.elf_image);
  const auto word = [&](std::size_t at) {
    return std::size_t{bytes[at]} << 24U | std::size_t{bytes[at + 1]} << 16U |
           std::size_t{bytes[at + 2]} << 8U | bytes[at + 3];
  };
  const std::size_t headers = word(32);
  const std::size_t header_bytes = word(46) >> 16U;
  const std::size_t header_count = word(48) >> 16U;
  return {reinterpret_cast<const char*>(bytes), headers + header_bytes * header_count};
}

ImageKind kind_of(const spe_program_handle_t& handle) {
  return image_kind(image_bytes(handle).bytes);
}

TEST(ElfHandle, has_a_real_spu_program_beside_that_of_the_host_engine) {
  EXPECT_EQ(list_gather_spu_elf.handle_size, sizeof(spe_program_handle_t));
  EXPECT_EQ(list_gather_spu_elf.toe_shadow, nullptr);
  EXPECT_EQ(kind_of(list_gather_spu_elf), ImageKind::spu_elf);
  EXPECT_EQ(kind_of(list_gather_spu), ImageKind::host_module);
}

TEST(ElfHandle, has_an_image_that_does_not_tell_where_it_was_built) {
  const std::string_view image = image_of(list_gather_spu_elf);
  ASSERT_GT(image.size(), 4096U);
  ASSERT_LT(image.size(), 1U << 20U);
  EXPECT_NE(image.find("list_gather_spu.elf"), std::string_view::npos) << "the note with the program's name";
  EXPECT_EQ(image.find(SPU_EMU_SOURCE_FOLDER), std::string_view::npos);
  EXPECT_EQ(image.find(SPU_EMU_BUILD_FOLDER), std::string_view::npos);
}

}  // namespace
}  // namespace spu_emu
