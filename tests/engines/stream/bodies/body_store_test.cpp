#include "engines/stream/bodies/body_store.h"

#include <gmock/gmock.h>

#include <limits>
#include <vector>

#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

constexpr Aabb kBox = {{1, 2, 3}, {4, 5, 6}};

class BodyStoreTest : public testing::Test {
 protected:
  void fill(std::size_t count) {
    const std::vector<Aabb> boxes(count, kBox);
    ASSERT_TRUE(store_.insert(ids_below(count), boxes).ok());
    store_.settle();
    store_.list_changes(1000);
  }
  Status move(const std::vector<BodyId>& ids, const Aabb& box) {
    return store_.move(pool_, ids, std::vector<Aabb>(ids.size(), box));
  }

  Pool pool_{2};
  BodyStore store_;
};

TEST_F(BodyStoreTest, ListsABodyOnceWithTheBoxItHadAndTheBoxItHas) {
  fill(10);
  ASSERT_TRUE(move({3}, {{0, 0, 0}, {1, 1, 1}}).ok());
  ASSERT_TRUE(move({3}, {{7, 7, 7}, {8, 8, 8}}).ok());
  const auto changes = store_.changes();
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].old_box, kBox);
  EXPECT_EQ(changes[0].new_box, (Aabb{{7, 7, 7}, {8, 8, 8}}));
  EXPECT_TRUE(changes[0].was && changes[0].is);
}

TEST_F(BodyStoreTest, DoesNotListABodyThatNoUpdateEverSaw) {
  fill(10);
  ASSERT_TRUE(store_.insert(std::vector<BodyId>{77}, std::vector<Aabb>{kBox}).ok());
  ASSERT_TRUE(store_.remove(std::vector<BodyId>{77}).ok());
  EXPECT_TRUE(store_.changes().empty());
}

TEST_F(BodyStoreTest, SeesNoChangeInTheSameBoxNorInAnotherSpellingOfIt) {
  const float denormal = std::numeric_limits<float>::denorm_min();
  ASSERT_TRUE(store_.insert(ids_below(100), std::vector<Aabb>(100, Aabb{{0, 0, 0}, {1, 1, 1}})).ok());
  store_.settle();
  ASSERT_TRUE(move(ids_below(100), {{0, 0, 0}, {1, 1, 1}}).ok());
  EXPECT_TRUE(store_.is_settled());
  store_.list_changes(1000);
  ASSERT_TRUE(move(ids_below(100), {{-0.0F, denormal, -denormal}, {1, 1, 1}}).ok());
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(store_.boxes()[i], (Aabb{{0, 0, 0}, {1, 1, 1}}));
}

TEST_F(BodyStoreTest, RefusesABadBoxWhereverItStandsAndChangesNothing) {
  fill(100);
  for (const std::size_t bad : {0, 1, 31, 32, 63, 99}) {
    std::vector<Aabb> boxes(100, Aabb{{0, 0, 0}, {1, 1, 1}});
    boxes[bad].max[bad % 3] = bad % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : -1.0F;
    const Status status = store_.move(pool_, ids_below(100), boxes);
    EXPECT_EQ(status.code, StatusCode::invalid_box);
    EXPECT_EQ(status.body, static_cast<BodyId>(bad));
    EXPECT_TRUE(store_.is_settled());
    for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(store_.boxes()[i], kBox);
  }
}

TEST_F(BodyStoreTest, StopsListingWhenThereIsTooMuchToList) {
  fill(100);
  store_.list_changes(5);
  ASSERT_TRUE(move({1, 2, 3}, Aabb{}).ok());
  EXPECT_FALSE(store_.too_many());
  ASSERT_TRUE(move({4, 5, 6}, Aabb{}).ok());
  EXPECT_TRUE(store_.too_many());
  store_.settle();
  EXPECT_TRUE(store_.is_settled());
}

}  // namespace
}  // namespace cellsweep::stream
