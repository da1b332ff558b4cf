// Copies between a local store and main memory, plain and with words swapped.
#include "mfc/copy.h"
#include "test_spu.h"

namespace spu_emu {
namespace {

TEST(Copy, copies_every_size_and_alignment_and_nothing_else) {
  for (std::size_t size = 0; size <= 300; ++size) {
    for (std::size_t offset = 0; offset < 9; ++offset) {
      std::array<std::byte, 512> from{};
      std::array<std::byte, 512> to{};
      for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<std::byte>(i * 3 + 1);
      copy_plain(to.data() + offset, from.data() + 2 * offset, size);
      for (std::size_t i = 0; i < to.size(); ++i) {
        const bool inside = i >= offset && i < offset + size;
        ASSERT_EQ(to[i], inside ? from[i + offset] : std::byte{0}) << size << ' ' << offset << ' ' << i;
      }
    }
  }
}

TEST(Copy, a_swapping_local_store_holds_words_in_the_other_byte_order) {
  TestSpu spu(DmaMode::eager, 1, WordOrder::swapped);
  for (const std::uint32_t size : {4U, 8U, 16U, 128U, 4096U}) {
    spu.dma(MFC_GET_CMD, 0x1000, spu.ea(), size, 0);
    for (std::uint32_t i = 0; i < size; ++i) ASSERT_EQ(spu.peek(0x1000 + i), spu.main->bytes[i ^ 3U]);
    spu.dma(MFC_PUT_CMD, 0x1000, spu.ea(8192), size, 0);
    for (std::uint32_t i = 0; i < size; ++i) ASSERT_EQ(spu.main->bytes[8192 + i], spu.main->bytes[i]);
  }
}

TEST(Copy, atomic_lines_are_swapped_too) {
  TestSpu spu(DmaMode::eager, 1, WordOrder::swapped);
  spu.dma(MFC_GETLLAR_CMD, 0x1000, spu.ea(), 128, 0);
  for (std::uint32_t i = 0; i < 128; ++i) ASSERT_EQ(spu.peek(0x1000 + i), spu.main->bytes[i ^ 3U]);
  spu.local->bytes[0x1000] = std::byte{0x55};
  spu.dma(MFC_PUTLLC_CMD, 0x1000, spu.ea(), 128, 0);
  EXPECT_EQ(spu.main->bytes[3], std::byte{0x55});
}

}  // namespace
}  // namespace spu_emu
