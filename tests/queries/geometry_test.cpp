/// @file
/// No touch is missed: paths among boxes of whole numbers, whose touches are known exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "cellsweep/query.h"
#include "contract/effort.h"
#include "contract/random.h"

namespace cellsweep::queries {
namespace {

using contract::Random;
using Whole = std::int64_t;

/// A number of the form over / under, under > 0, both small.
struct Fraction {
  Whole over = 0;
  Whole under = 1;

  friend bool operator<(const Fraction& one, const Fraction& other) {
    return one.over * other.under < other.over * one.under;
  }
};

/// Exactly, of a path whose numbers are all whole: when it touches first, if it does up to its end.
bool touches(const Path& path, const Aabb& box, Fraction& time) {
  Fraction enter{0, 1};
  Fraction leave{static_cast<Whole>(path.end), 1};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto d = static_cast<Whole>(path.direction[axis]);
    const Whole before = static_cast<Whole>(box.min[axis]) - static_cast<Whole>(path.box.max[axis]);
    const Whole behind = static_cast<Whole>(box.max[axis]) - static_cast<Whole>(path.box.min[axis]);
    if (d == 0) {
      if (before > 0 || behind < 0) return false;
      continue;
    }
    const Fraction from = d > 0 ? Fraction{before, d} : Fraction{-behind, -d};
    const Fraction to = d > 0 ? Fraction{behind, d} : Fraction{-before, -d};
    enter = std::max(enter, from);
    leave = std::min(leave, to);
  }
  time = enter;
  return !(leave < enter);
}

class WholeWorld {
 public:
  WholeWorld(Random& random, std::size_t count, int most) : random_(random), most_(most) {
    for (std::size_t i = 0; i < count; ++i) boxes_.push_back(box());
    std::vector<BodyId> ids(count);
    std::iota(ids.begin(), ids.end(), BodyId{0});
    EXPECT_TRUE(broadphase_.insert(ids, boxes_).ok());
    EXPECT_TRUE(broadphase_.update().ok());
  }

  Queries queries() const { return broadphase_.queries(); }
  const std::vector<Aabb>& boxes() const { return boxes_; }

  Aabb box() {
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = number();
      box.max[axis] = box.min[axis] + static_cast<float>(random_.whole(0, 3));
    }
    return box;
  }
  Path path() {
    Path path;
    path.box = random_.one_in(2) ? box() : box_at({number(), number(), number()});
    do {
      for (double& d : path.direction) d = random_.whole(-7, 7);
    } while (path.direction == std::array<double, 3>{});
    path.end = random_.whole(0, 20);
    return path;
  }

 private:
  float number() { return static_cast<float>(random_.whole(-most_, most_)); }

  Random& random_;
  int most_;
  std::vector<Aabb> boxes_;
  Broadphase broadphase_;
};

// In small numbers as much touches as in large ones, where floats are whole numbers and nothing else.
TEST(QueryGeometry, NoTouchOfWholeNumbersIsMissed) {
  constexpr int kPaths = contract::effort(2000, 200, 50);
  Random random(1);
  for (const int most : {4, 20, 8'000'000}) {
    WholeWorld world(random, 3000, most);
    std::vector<Touch> found;
    for (int i = 0; i < kPaths; ++i) {
      if (i == kPaths / 2) world.queries().prepare();
      const Path path = world.path();
      ASSERT_TRUE(world.queries().find_touches(path, found).ok());
      std::vector<double> times(world.boxes().size(), -1);
      for (const Touch& touch : found) times[touch.body] = touch.time;
      for (std::size_t body = 0; body < times.size(); ++body) {
        Fraction time;
        if (!touches(path, world.boxes()[body], time)) continue;
        const double exact = static_cast<double>(time.over) / static_cast<double>(time.under);
        ASSERT_DOUBLE_EQ(times[body], exact) << "path " << i << " up to " << most << ", body " << body;
      }
    }
  }
}

// Bodies that share a corner with the line between two corners, one after the other.
TEST(QueryGeometry, ARayAlongCornersTouchesEachBox) {
  Broadphase broadphase;
  constexpr int kBoxes = 3000;
  for (int i = 0; i < kBoxes; ++i) {
    const auto at = static_cast<float>(i) * 0.1F;
    ASSERT_TRUE(broadphase.insert(static_cast<BodyId>(i), {{at, at, at}, {at + 0.05F, at + 1, at + 2}}).ok());
  }
  ASSERT_TRUE(broadphase.update().ok());
  for (int time = 0; time < 2; ++time) {
    std::vector<Touch> found;
    ASSERT_TRUE(broadphase.queries().find_touches(Ray{{-1, -1, -1}, {0.1, 0.1, 0.1}}, found).ok());
    ASSERT_EQ(found.size(), std::size_t{kBoxes});
    for (int i = 0; i < kBoxes; ++i)
      EXPECT_EQ(found[static_cast<std::size_t>(i)].body, static_cast<BodyId>(i));
    broadphase.queries().prepare();
  }
}

TEST(QueryGeometry, ASegmentEndsAtItsLastPoint) {
  Broadphase broadphase;
  ASSERT_TRUE(broadphase.insert(1, {{3, -1, -1}, {4, 1, 1}}).ok());
  ASSERT_TRUE(broadphase.update().ok());
  const Queries queries = broadphase.queries();
  EXPECT_TRUE(*queries.any_touch(Ray::between({0, 0, 0}, {3, 0.5F, 0})));
  EXPECT_FALSE(*queries.any_touch(Ray::between({0, 0, 0}, {2.9999998F, 0.5F, 0})));
  const auto touch = *queries.first_touch(Ray::between({0, 0, 0}, {6, 0, 0}));
  ASSERT_TRUE(touch.has_value());
  EXPECT_EQ(touch->time, 0.5);
}

TEST(QueryGeometry, AMovingBoxTouchesWithItsFaces) {
  Broadphase broadphase;
  ASSERT_TRUE(broadphase.insert(1, {{3, 0, 0}, {4, 2, 1}}).ok());
  ASSERT_TRUE(broadphase.insert(2, {{3, 2.5F, 0}, {4, 3, 1}}).ok());
  ASSERT_TRUE(broadphase.update().ok());
  std::vector<Touch> found;
  ASSERT_TRUE(broadphase.queries().find_touches(MovingBox{{{0, 0, 0}, {1, 1, 1}}, {4, 3, 0}}, found).ok());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], (Touch{1, 0.5}));
  EXPECT_EQ(found[1], (Touch{2, 0.5}));
}

TEST(QueryGeometry, WhatAPathBeginsInIsTouchedAtOnce) {
  Broadphase broadphase;
  ASSERT_TRUE(broadphase.insert(5, {{-1, -1, -1}, {1, 1, 1}}).ok());
  ASSERT_TRUE(broadphase.insert(4, {{1, 1, 1}, {2, 2, 2}}).ok());
  ASSERT_TRUE(broadphase.update().ok());
  std::vector<Touch> found;
  ASSERT_TRUE(broadphase.queries().find_touches(Ray{{1, 1, 1}, {0, 0, -1}}, found).ok());
  EXPECT_EQ(found, (std::vector<Touch>{{4, 0}, {5, 0}}));
  ASSERT_TRUE(broadphase.queries().find_touches(Ray{{0, 0, 0}, {0, 0, -1}, 0}, found).ok());
  EXPECT_EQ(found, (std::vector<Touch>{{5, 0}}));
}

}  // namespace
}  // namespace cellsweep::queries
