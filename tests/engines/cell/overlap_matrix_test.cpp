/// @file
/// The matrix of overlap bits: both sides of a pair, growth, and reading it out.
#include "engines/cell/ppu/overlap_matrix.h"

#include <gmock/gmock.h>

namespace cellsweep::cell {
namespace {

using Visits = std::vector<std::pair<Slot, Slot>>;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

Visits drained(OverlapMatrix& matrix) {
  Visits visits;
  matrix.drain([&](Slot row, Slot column) { visits.emplace_back(row, column); });
  return visits;
}

TEST(OverlapMatrix, KnowsAPairFromBothSides) {
  OverlapMatrix matrix;
  matrix.grow(64);
  matrix.set(3, 40);
  EXPECT_TRUE(matrix.test(3, 40));
  EXPECT_TRUE(matrix.test(40, 3));
  EXPECT_FALSE(matrix.test(40, 4));
  matrix.reset(40, 3);
  EXPECT_FALSE(matrix.test(3, 40));
}

TEST(OverlapMatrix, KeepsItsBitsWhenItGrows) {
  OverlapMatrix matrix;
  matrix.grow(32);
  matrix.set(31, 0);
  matrix.set(5, 6);
  matrix.grow(128);
  EXPECT_EQ(matrix.slots(), 128U);
  EXPECT_THAT(drained(matrix), ElementsAre(Pair(6, 5), Pair(31, 0)));
}

TEST(OverlapMatrix, DrainsInAscendingOrderAndIsEmptyThen) {
  OverlapMatrix matrix;
  matrix.grow(64);
  for (const auto& [a, b] : Visits{{60, 2}, {1, 60}, {63, 62}, {2, 1}}) matrix.set(a, b);
  EXPECT_THAT(drained(matrix), ElementsAre(Pair(2, 1), Pair(60, 1), Pair(60, 2), Pair(63, 62)));
  EXPECT_THAT(drained(matrix), IsEmpty());
}

TEST(OverlapMatrix, TellsWhatDiffersFromTheRowBeforeButNotTheBodyItself) {
  OverlapMatrix matrix;
  matrix.grow(32);
  matrix.set(1, 7);
  const std::vector<std::uint32_t> row = {(1U << 31 >> 1) | (1U << 31 >> 9)};
  std::vector<std::pair<Slot, bool>> changes;
  matrix.replace_row(1, row, [&](Slot other, bool now) { changes.emplace_back(other, now); });
  EXPECT_THAT(changes, ElementsAre(Pair(7, false), Pair(9, true)));
  EXPECT_TRUE(matrix.test(9, 1));
  EXPECT_FALSE(matrix.test(7, 1));
}

TEST(OverlapMatrix, ClearsARowAndItsColumn) {
  OverlapMatrix matrix;
  matrix.grow(64);
  matrix.set(8, 1);
  matrix.set(8, 50);
  matrix.set(1, 50);
  std::vector<Slot> ended;
  matrix.clear(8, [&](Slot other) { ended.push_back(other); });
  EXPECT_THAT(ended, ElementsAre(1, 50));
  EXPECT_THAT(drained(matrix), ElementsAre(Pair(50, 1)));
}

}  // namespace
}  // namespace cellsweep::cell
