/// @file
/// cell-brute: its SIMD test of one body against all, and its options.
#include <gmock/gmock.h>

#include <random>

#include "base/sanitized.h"
#include "engines/cell/cell_world.h"
#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/spu/brute/overlap_row.h"

namespace cellsweep::cell {
namespace {

TEST(OverlapRow, AgreesWithTheScalarTestOnEveryBody) {
  std::mt19937 random(4);
  constexpr std::uint32_t kBodies = 256;
  std::vector<Aabb> boxes(kBodies);
  DmaVector<float> arrays(6 * kBodies);
  for (std::uint32_t i = 0; i < kBodies; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      boxes[i].min[axis] = static_cast<float>(random() % 6);
      boxes[i].max[axis] = boxes[i].min[axis] + static_cast<float>(random() % 3);
      arrays[axis * kBodies + i] = boxes[i].min[axis];
      arrays[(axis + 3) * kBodies + i] = boxes[i].max[axis];
    }
  }
  std::vector<std::uint32_t> row(kBodies / 32);
  for (std::uint32_t i = 0; i < kBodies; ++i) {
    overlap_row(reinterpret_cast<const vec_float4*>(arrays.data()), kBodies, i, row.data());
    for (std::uint32_t j = 0; j < kBodies; ++j) {
      const bool bit = (row[j / 32] >> (31 - j % 32) & 1) != 0;
      ASSERT_EQ(bit, overlap(boxes[i], boxes[j])) << i << " and " << j;
    }
  }
}

TEST(CellBrute, TakesAtMost16Spus) {
  EXPECT_TRUE(make_broadphase(CellBruteOptions{.spus = 16}).ok());
  const Status status = make_broadphase(CellBruteOptions{.spus = 17}).status();
  EXPECT_EQ(status.code, StatusCode::bad_option);
  EXPECT_EQ(status.setting, "spus");
  EXPECT_EQ(status.number, 17U);
  EXPECT_EQ(status.limit, 16U);
}

TEST(CellBrute, RefusesALocalStoreWithoutRoomForOneBody) {
  const Status status = make_broadphase(CellBruteOptions{.spes = {.local_store = 69 << 10}}).status();
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.setting, "local_store");
  EXPECT_THAT(status.message, testing::HasSubstr("cannot hold a single body"));
  EXPECT_GT(status.number, status.limit);
}

TEST(CellBrute, UsesNoMoreLocalStoreThanItsMapSays) {
  if (kIsSanitized) GTEST_SKIP() << "a sanitizer's data count too";
  Broadphase engine = make(CellBruteOptions{.spus = 1});
  ASSERT_TRUE(engine.insert(ids_up_to(300), std::vector<Aabb>(300)).ok());
  ASSERT_TRUE(engine.update().ok());
  const auto map = local_store_map(CellBruteOptions(), 384);  // rows are whole blocks of 128
  ASSERT_TRUE(map.ok());
  EXPECT_LE(cell_statistics(engine)->local_store_high_water, map->used());
}

}  // namespace
}  // namespace cellsweep::cell
