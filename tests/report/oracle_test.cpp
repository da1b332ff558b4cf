#include "report/oracle.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>

namespace cellsweep::report {
namespace {

TEST(OraclePairs, AreAllThatOverlapOrTouchAscending) {
  const std::vector<Aabb> boxes = {
      {{0, 0, 0}, {1, 1, 1}}, {{5, 5, 5}, {6, 6, 6}}, {{1, 1, 1}, {2, 2, 2}}, {{0, 0, 0}, {9, 9, 9}}};
  EXPECT_THAT(oracle_pairs(boxes), testing::ElementsAre(Pair{0, 2}, Pair{0, 3}, Pair{1, 3}, Pair{2, 3}));
}

TEST(OraclePairs, OfNoBoxesAreNone) {
  EXPECT_THAT(oracle_pairs(std::span<const Aabb>()), testing::IsEmpty());
}

}  // namespace
}  // namespace cellsweep::report
