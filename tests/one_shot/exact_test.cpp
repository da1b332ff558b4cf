/// @file
/// Boxes of floats around boxes of doubles: none is missed, and no set has many that overlap for nothing.
#include "one_shot/exact.h"

#include <gtest/gtest.h>

#include "one_shot/sets_of_boxes.h"

namespace cellsweep::one_shot {
namespace {

std::vector<Aabb> in(const Array<Aabb>& boxes) {
  return {boxes.data(), boxes.data() + boxes.size()};
}

template <class Make>
std::vector<Aabb> made_of(const std::vector<ExactBox>& exact, const Make& make) {
  Array<Aabb> boxes;
  make(exact, boxes);
  return in(boxes);
}

TEST(Rounded, OverlapWhereTheExactOnesDo) {
  for (const DoubleKind& kind : double_kinds()) {
    const auto exact = kind.make(500, 3);
    const auto rounded = made_of(exact, make_rounded);
    for (const Pair pair : true_pairs(exact))
      EXPECT_TRUE(touch(rounded[pair.a], rounded[pair.b])) << kind.name << " " << pair.a << " " << pair.b;
    for (const Aabb& box : rounded) {
      for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_LT(box.min[axis], box.max[axis]) << kind.name;
    }
  }
}

TEST(Rounded, AreFineAroundTheMiddleHoweverFarFromZeroThatIs) {
  const auto exact = double_kinds()[1].make(500, 3);
  EXPECT_EQ(true_pairs(made_of(exact, make_rounded)), true_pairs(exact));
}

TEST(Ranked, OverlapWhereTheExactOnesDoAndNowhereElse) {
  for (const DoubleKind& kind : double_kinds()) {
    const auto exact = kind.make(500, 3);
    EXPECT_EQ(true_pairs(made_of(exact, make_ranked)), true_pairs(exact)) << kind.name;
  }
}

TEST(Ranked, AreWhatIsSearchedWhereRoundedOnesOverlapForNothing) {
  const auto exact = two_tiny_clusters(2000, 3);
  const std::size_t rounded = true_pairs(made_of(exact, make_rounded)).size();
  EXPECT_GT(rounded, 100'000U) << "a million, nearly: half of them are as good as one point";
}

}  // namespace
}  // namespace cellsweep::one_shot
