/// @file
/// The box around boxes, be there many, one or none.
#include "geometry/bounds.h"

#include <gtest/gtest.h>

namespace cellsweep {
namespace {

TEST(Bounds, AroundNoneAreThePointAtTheOrigin) {
  const Bounds bounds;
  EXPECT_TRUE(bounds.empty());
  EXPECT_EQ(bounds.box(), Aabb{});
}

TEST(Bounds, AroundOneAreItself) {
  const Aabb far{{7, -9, 1e30F}, {8, -8, 2e30F}};
  Bounds bounds;
  bounds.include(far);
  EXPECT_FALSE(bounds.empty());
  EXPECT_EQ(bounds.box(), far);
}

TEST(Bounds, AroundSeveralTouchTheOutermostOnEachSide) {
  Bounds bounds;
  bounds.include({{0, 0, 0}, {1, 1, 1}});
  bounds.include({{-2, 0.5F, 3}, {-1, 9, 4}});
  bounds.include({{0, -5, 0}, {0, -5, 0}});
  EXPECT_EQ(bounds.box(), (Aabb{{-2, -5, 0}, {1, 9, 4}}));
}

}  // namespace
}  // namespace cellsweep
