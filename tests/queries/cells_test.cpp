/// @file
/// The cells that questions go through are those of the last update, and none after one that failed.
#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "broadphase/last_update.h"
#include "cellsweep/engine/engine.h"
#include "cellsweep/query.h"

namespace cellsweep::queries {
namespace {

/// Cubes with room between them, and calls that move them all.
class Cubes : public testing::Test {
 protected:
  static constexpr std::size_t kBodies = 3000;  // more than are swept without cells

  Cubes() : ids_(kBodies), boxes_(kBodies) {
    std::iota(ids_.begin(), ids_.end(), BodyId{0});
    put(0, 1);
    EXPECT_TRUE(broadphase_.insert(ids_, boxes_).ok());
  }

  /// In a row, from `first` on.
  void put(float first, float edge) {
    for (std::size_t i = 0; i < kBodies; ++i) {
      const float low = first + 2 * static_cast<float>(i);
      boxes_[i] = {{low, 0, 0}, {low + edge, 1, 1}};
    }
  }
  Status move_to(float first, float edge) {
    put(first, edge);
    EXPECT_TRUE(broadphase_.move(ids_, boxes_).ok());
    return broadphase_.update().status();
  }
  const stream::Node* root() const { return EngineAccess::last_update(broadphase_).cells.root; }
  std::vector<BodyId> overlap(const Region& region) const {
    std::vector<BodyId> found;
    EXPECT_TRUE(broadphase_.queries().find_overlaps(region, found).ok());
    return found;
  }

  std::vector<BodyId> ids_;
  std::vector<Aabb> boxes_;
  Broadphase broadphase_ = std::move(*make_broadphase(StreamOptions{.threads = 1, .max_pairs = 100}));
};

TEST_F(Cubes, HaveCellsFromTheirFirstUpdateOn) {
  EXPECT_EQ(root(), nullptr);
  ASSERT_TRUE(broadphase_.update().ok());
  EXPECT_NE(root(), nullptr);
  ASSERT_TRUE(broadphase_.update().ok());
  EXPECT_EQ(root(), EngineAccess::engine_of(broadphase_).cells().root);
}

TEST_F(Cubes, OfAFailedUpdateAreNotSeen) {
  ASSERT_TRUE(broadphase_.update().ok());
  ASSERT_EQ(move_to(5000, 3).code, StatusCode::capacity);
  EXPECT_EQ(root(), nullptr);
  EXPECT_EQ(overlap(Point{200.5F, 0, 0}), std::vector<BodyId>{100});
  EXPECT_EQ(overlap(Point{8000, 0, 0}), std::vector<BodyId>{});
  ASSERT_TRUE(move_to(5000, 1).ok());
  EXPECT_NE(root(), nullptr);
  EXPECT_EQ(overlap(Point{5200.5F, 0, 0}), std::vector<BodyId>{100});
}

/// Has other cells after each update, also where nothing has changed.
class RestlessEngine final : public Engine {
 public:
  Capacity capacity() const override { return {}; }
  Result<FoundPairs> update(const BodyChanges& /*changes*/, Statistics& /*statistics*/) override {
    are_exact_ = !are_exact_;
    return FoundPairs();
  }
  CellsToQuery cells() const override { return {nullptr, VectorIsa::best, are_exact_}; }

 private:
  bool are_exact_ = false;
};

TEST(CellsToQuery, AreAskedForAfterEachUpdate) {
  auto made = EngineAccess::make(
      "restless", [] { return Result<std::unique_ptr<Engine>>(std::make_unique<RestlessEngine>()); });
  ASSERT_TRUE(made.ok());
  for (int update = 0; update < 3; ++update) {
    ASSERT_TRUE(made->update().ok());
    EXPECT_EQ(EngineAccess::last_update(*made).cells.are_exact,
              EngineAccess::engine_of(*made).cells().are_exact);
  }
}

}  // namespace
}  // namespace cellsweep::queries
