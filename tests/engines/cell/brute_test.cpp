/// @file
/// cell-brute: its SIMD test of one body against all, and its options.
#include <gmock/gmock.h>

#include <random>

#include "cellsweep/aabb.h"
#include "cellsweep/engines.h"
#include "cellsweep/local_store.h"
#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/sanitized.h"
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
  EXPECT_TRUE(make_engine("cell-brute", {.spus = 16}).ok());
  const auto made = make_engine("cell-brute", {.spus = 17});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.status().setting, "spus");
}

TEST(CellBrute, UsesNoMoreLocalStoreThanItsMapSays) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer's data count too";
  const auto engine = std::move(*make_engine("cell-brute", {.spus = 1}));
  for (BodyId id = 0; id < 300; ++id) ASSERT_TRUE(engine->insert(id, Aabb{}).ok());
  ASSERT_TRUE(engine->update().ok());
  const auto map = local_store_map("cell-brute", {}, 512);  // the engine's arrays grow by doubling
  ASSERT_TRUE(map.ok());
  for (const Counter& counter : engine->statistics().counters) {
    if (counter.name != "local store high water") continue;
    EXPECT_LE(counter.value, map->used());
  }
}

}  // namespace
}  // namespace cellsweep::cell
