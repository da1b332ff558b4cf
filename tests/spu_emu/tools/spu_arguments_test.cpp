// The command line of a program that runs alone, for both kinds of start-up code.
#include "tools/spu_arguments.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "../isa/elf/elf_builder.h"
#include "../isa/encoding/assembler.h"
#include "mfc/mapped.h"

namespace spu_emu {
namespace {

using isa::encode;

/// What a DMA of these registers' region would bring into the local store.
std::vector<std::byte> fetched(unsigned int high, unsigned int low, std::uint32_t size) {
  const auto* words = reinterpret_cast<const std::uint32_t*>((std::uint64_t{high} << 32U) | low);
  std::vector<std::byte> bytes(size);
  for (std::uint32_t i = 0; i < size / 4; ++i) isa::write_word(bytes.data() + 4 * i, words[i]);
  return bytes;
}

TEST(SpuArguments, standard_main_gets_a_region_at_the_top_of_the_local_store) {
  SpuArguments arguments(MainKind::standard, {"prog", "x"}, 0x40000);
  const auto& r = arguments.registers();
  EXPECT_EQ(r[0], 2U);
  EXPECT_EQ(r[7], 32U);
  EXPECT_EQ(r[4], 0x40000U - 32);
  const auto region = fetched(r[5], r[6], r[7]);
  EXPECT_EQ(isa::read_word(region.data()), r[4] + 12);
  EXPECT_EQ(isa::read_word(region.data() + 4), r[4] + 17);
  EXPECT_EQ(isa::read_word(region.data() + 8), 0U);
  EXPECT_STREQ(reinterpret_cast<const char*>(region.data() + 12), "prog");
  EXPECT_STREQ(reinterpret_cast<const char*>(region.data() + 17), "x");
}

TEST(SpuArguments, another_main_gets_the_texts_and_their_size) {
  SpuArguments arguments(MainKind::spe, {"prog", "x"}, 0x40000);
  const auto& r = arguments.registers();
  EXPECT_EQ(r[1], 1U);
  EXPECT_EQ(r[9], 16U);
  const auto texts = fetched(r[4], r[5], r[9]);
  EXPECT_STREQ(reinterpret_cast<const char*>(texts.data() + 5), "x");
}

TEST(SpuArguments, a_program_has_a_megabyte_behind_its_arguments_and_nothing_before) {
  SpuArguments arguments(MainKind::spe, {"prog"}, 0x40000);
  const auto& r = arguments.registers();
  const std::uint64_t argp = (std::uint64_t{r[4]} << 32U) | r[5];
  const auto mapped = [](std::uint64_t address, std::uint64_t size) {
    return is_mapped(address, size, Access::write);
  };
  EXPECT_TRUE(mapped(argp, std::uint64_t{1} << 20U));
  EXPECT_FALSE(mapped(argp - 16, 16));
  EXPECT_FALSE(mapped(argp + (std::uint64_t{1} << 20U), 16));
  EXPECT_EQ(fetched(r[4], r[5], 64)[40], std::byte{0});
}

TEST(SpuArguments, more_than_one_transfer_is_refused) {
  EXPECT_THROW(SpuArguments(MainKind::standard, {std::string(16384, 'x')}, 0x40000), std::length_error);
}

TEST(SpuArguments, start_up_code_that_issues_dma_is_for_the_standard_main) {
  const auto kind = [](std::uint32_t word) {
    return main_kind(isa::ElfBuilder(0x80, {{0x80, {encode("nop", {0}), word, 0}}}).build());
  };
  EXPECT_EQ(kind(encode("wrch", {21, 2})), MainKind::standard);
  EXPECT_EQ(kind(encode("wrch", {20, 2})), MainKind::spe);
  EXPECT_EQ(main_kind({}), MainKind::spe);
}

}  // namespace
}  // namespace spu_emu
