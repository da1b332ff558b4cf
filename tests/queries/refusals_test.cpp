/// @file
/// Questions without an answer are refused by name, and nothing is written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cellsweep/query.h"

namespace cellsweep::queries {
namespace {

using testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr Aabb kCube = {{0, 0, 0}, {1, 1, 1}};

class RefusedQueries : public testing::Test {
 protected:
  RefusedQueries() {
    EXPECT_TRUE(broadphase_.insert(1, kCube).ok());
    EXPECT_TRUE(broadphase_.update().ok());
  }

  Status overlaps(const Region& region) {
    return kept(bodies_, [&] { return queries_.find_overlaps(region, bodies_); });
  }
  Status touches(const Path& path) {
    return kept(touches_, [&] { return queries_.find_touches(path, touches_); });
  }

  template <class Answers, class Call>
  static Status kept(const Answers& answers, const Call& call) {
    const Answers before = answers;
    Status status = call();
    EXPECT_EQ(answers, before);
    return status;
  }

  Broadphase broadphase_;
  Queries queries_{broadphase_};
  std::vector<BodyId> bodies_ = {3, 4};
  std::vector<Touch> touches_ = {{5, 6}};
  std::vector<Neighbor> neighbors_ = {{7, 8}};
};

TEST_F(RefusedQueries, BoxesThatAreNone) {
  const Status inverted = overlaps(Aabb{{0, 2, 0}, {1, 1, 1}});
  EXPECT_EQ(inverted.code, StatusCode::invalid_box);
  EXPECT_THAT(inverted.message, HasSubstr("on axis y it goes from 2 to 1"));
  EXPECT_EQ(overlaps(Point{0, 0, kNaN}).code, StatusCode::invalid_box);
  EXPECT_EQ(overlaps(Point{0, std::numeric_limits<float>::infinity(), 0}).code, StatusCode::invalid_box);
  EXPECT_EQ(touches(Ray{{kNaN, 0, 0}, {1, 0, 0}}).code, StatusCode::invalid_box);
  EXPECT_EQ(kept(neighbors_,
                 [&] {
                   return queries_.find_nearest(Point{kNaN, 0, 0}, 1, neighbors_);
                 })
                .code,
            StatusCode::invalid_box);
}

TEST_F(RefusedQueries, DirectionsThatLeadNowhere) {
  const Status zero = touches(Ray{{0, 0, 0}, {0, -0.0, 0}});
  EXPECT_EQ(zero.code, StatusCode::bad_input);
  EXPECT_THAT(zero.message, HasSubstr("The direction is (0, -0, 0)"));
  EXPECT_EQ(touches(Ray{{0, 0, 0}, {0, std::nan(""), 1}}).code, StatusCode::bad_input);
  EXPECT_EQ(touches(Ray{{0, 0, 0}, {kUnbounded, 0, 1}}).code, StatusCode::bad_input);
  EXPECT_EQ(touches(Ray{{0, 0, 0}, {1e39, 0, 1}}).code, StatusCode::bad_input);
  EXPECT_FALSE(queries_.first_touch(Ray{}).ok());
  EXPECT_FALSE(queries_.any_touch(MovingBox{kCube}).ok());
}

TEST_F(RefusedQueries, WhatIsBeyondFloatsOnAnyAxis) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const float number : {kInfinite, -kInfinite, kNaN}) {
      Aabb box = kCube;
      (number > 0 ? box.max : box.min)[axis] = number;
      EXPECT_EQ(overlaps(box).code, StatusCode::invalid_box) << axis << ' ' << number;
    }
    Ray ray;
    ray.direction[axis] = -std::numeric_limits<float>::max();
    EXPECT_TRUE(queries_.any_touch(ray).ok()) << axis;
    ray.direction[(axis + 1) % 3] = std::numeric_limits<float>::max();
    EXPECT_TRUE(queries_.any_touch(ray).ok()) << axis << ": each fits, and their sum does not";
    ray.direction[axis] = -3.5e38;
    EXPECT_EQ(queries_.any_touch(ray).status().code, StatusCode::bad_input) << axis;
    ray.direction[axis] = std::nan("");
    EXPECT_EQ(queries_.any_touch(ray).status().code, StatusCode::bad_input) << axis;
  }
  EXPECT_EQ(overlaps(Point{0, kNaN, 0}).code, StatusCode::invalid_box);
}

TEST_F(RefusedQueries, LengthsBelowZero) {
  const Status radius = overlaps(Sphere{{0, 0, 0}, -1});
  EXPECT_EQ(radius.code, StatusCode::bad_input);
  EXPECT_THAT(radius.message, HasSubstr("The distance is -1"));
  EXPECT_EQ(overlaps(Sphere{{0, 0, 0}, std::nan("")}).code, StatusCode::bad_input);
  EXPECT_EQ(touches(Ray{{0, 0, 0}, {1, 0, 0}, -1e-9}).code, StatusCode::bad_input);
  EXPECT_EQ(touches(Ray{{0, 0, 0}, {1, 0, 0}, std::nan("")}).code, StatusCode::bad_input);
  const auto nearest = [&] { return queries_.find_nearest(kCube, 1, neighbors_, -2); };
  EXPECT_THAT(kept(neighbors_, nearest).message, HasSubstr("The largest distance is -2"));
}

TEST_F(RefusedQueries, ABatchWithOneAmongThem) {
  BatchAnswers<BodyId> found{{0, 1}, {9}};
  const std::vector<Region> regions = {kCube, kCube, Aabb{{3, 0, 0}, {1, 1, 1}}};
  const Status status = queries_.find_overlaps(regions, found);
  EXPECT_EQ(status.code, StatusCode::invalid_box);
  EXPECT_THAT(status.message, HasSubstr("The box of question 2 is refused"));
  EXPECT_EQ(found.answers, std::vector<BodyId>{9});
  std::vector<std::optional<Touch>> first(2);
  const std::vector<Path> paths(3, Path(Ray{{0, 0, 0}, {1, 0, 0}}));
  EXPECT_THAT(queries_.first_touches(paths, first).message, HasSubstr("3 questions and room for 2 answers"));
}

TEST_F(RefusedQueries, PairsOfBodiesThatNoUpdateSaw) {
  ASSERT_TRUE(broadphase_.insert(2, kCube).ok());
  std::vector<Pair> pairs = {{1, 2}};
  const std::vector<BodyId> bodies = {1, 2, 33};
  const Status status = queries_.find_pairs_of(bodies, pairs);
  EXPECT_EQ(status.code, StatusCode::unknown_body);
  EXPECT_EQ(status.bodies, (std::vector<BodyId>{2, 33}));
  EXPECT_EQ(pairs, (std::vector<Pair>{{1, 2}}));
}

TEST_F(RefusedQueries, NothingIsAskedOfAnEmptyWorld) {
  Broadphase empty;
  std::vector<Neighbor> found = {{1, 1}};
  ASSERT_TRUE(empty.queries().find_nearest(Point{0, 0, 0}, 3, found).ok());
  EXPECT_TRUE(found.empty());
  ASSERT_TRUE(empty.insert(1, kCube).ok());
  EXPECT_FALSE(*empty.queries().any_overlap(kCube)) << "before the first update";
  EXPECT_EQ(*empty.queries().first_touch(Ray{{0, 0, 0}, {1, 0, 0}}), std::nullopt);
}

}  // namespace
}  // namespace cellsweep::queries
