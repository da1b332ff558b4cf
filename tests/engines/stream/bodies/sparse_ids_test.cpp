#include "broadphase/bodies/sparse_ids.h"

#include <gtest/gtest.h>

#include <map>

#include "contract/random.h"

namespace cellsweep::stream {
namespace {

TEST(SparseIds, AreFoundWhateverCameAndWent) {
  contract::Random random(1);
  SparseIds ids;
  std::map<BodyId, std::uint32_t> truth;
  for (std::uint32_t step = 0; step < 20'000; ++step) {
    const auto id = static_cast<BodyId>(random.below(500) * 8'000'000);
    const auto held = truth.find(id);
    ASSERT_EQ(ids.find(id), held == truth.end() ? SparseIds::kNone : held->second);
    if (held == truth.end()) {
      ids.insert(id, step);
      truth[id] = step;
    } else {
      ids.erase(id);
      truth.erase(held);
    }
    ASSERT_EQ(ids.size(), truth.size());
  }
  for (const auto& [id, slot] : truth) EXPECT_EQ(ids.find(id), slot);
}

TEST(SparseIds, HaveRoomForAsManyAsWereAskedFor) {
  SparseIds ids;
  ids.reserve(1000);
  const std::size_t bytes = ids.bytes();
  for (BodyId id = 0; id < 1000; ++id) ids.insert(~id, id);
  EXPECT_EQ(ids.bytes(), bytes);
  EXPECT_LE(bytes, 32U * 1024);
}

}  // namespace
}  // namespace cellsweep::stream
