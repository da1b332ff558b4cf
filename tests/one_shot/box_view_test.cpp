/// @file
/// Boxes are read from wherever the caller has them.
#include "cellsweep/box_view.h"

#include <gmock/gmock.h>

#include <cstring>

#include "one_shot/sets_of_boxes.h"

namespace cellsweep::one_shot {
namespace {

template <class Number, std::size_t kAxes>
class CoordinatesOf {
 public:
  explicit CoordinatesOf(std::vector<Box<Number, kAxes>> boxes) : boxes_(std::move(boxes)) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      for (const auto& box : boxes_) {
        separate_[axis].push_back(box.min[axis]);
        separate_[axis + kAxes].push_back(box.max[axis]);
      }
    }
  }

  CoordinateArrays<Number, kAxes> separate() const {
    CoordinateArrays<Number, kAxes> arrays;
    arrays.count = boxes_.size();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      arrays.min[axis] = {separate_[axis].data()};
      arrays.max[axis] = {separate_[axis + kAxes].data()};
    }
    return arrays;
  }

  /// From the last box to the first one.
  CoordinateArrays<Number, kAxes> backwards() const {
    auto arrays = separate();
    for (auto* faces : {&arrays.min, &arrays.max}) {
      for (auto& face : *faces)
        face = {face.first + arrays.count - 1, -static_cast<std::ptrdiff_t>(sizeof(Number))};
    }
    return arrays;
  }

  const std::vector<Box<Number, kAxes>>& boxes() const { return boxes_; }

 private:
  std::vector<Box<Number, kAxes>> boxes_;
  std::array<std::vector<Number>, 2 * kAxes> separate_;
};

template <class Number, std::size_t kAxes>
void expect_reads_coordinates() {
  const CoordinatesOf<Number, kAxes> coordinates(cut_to<Number, kAxes>(double_kinds()[0].make(400, 1)));
  const auto truth = true_pairs(coordinates.boxes());
  EXPECT_EQ(*find_pairs(coordinates.boxes()), truth);
  EXPECT_EQ(*find_pairs(coordinates.separate()), truth);
  auto reversed = coordinates.boxes();
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(*find_pairs(coordinates.backwards()), true_pairs(reversed));
  EXPECT_EQ(*find_pairs(coordinates.separate(), coordinates.backwards()),
            true_pairs(coordinates.boxes(), reversed));
}

TEST(BoxView, ReadsArraysOfCoordinatesForwardsAndBackwards) {
  expect_reads_coordinates<float, 2>();
  expect_reads_coordinates<float, 3>();
  expect_reads_coordinates<double, 2>();
  expect_reads_coordinates<double, 3>();
}

/// A body of the caller's with a box in it, and one float more than a multiple of doubles before it.
struct [[gnu::packed]] Body {
  char name[3];
  double low[3];
  char more;
  double high[3];
};

TEST(BoxView, ReadsCoordinatesThatAreNotAligned) {
  const auto boxes = double_kinds()[0].make(300, 2);
  std::vector<Body> bodies(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::memcpy(reinterpret_cast<char*>(&bodies[i]) + offsetof(Body, low), boxes[i].min.data(), 24);
    std::memcpy(reinterpret_cast<char*>(&bodies[i]) + offsetof(Body, high), boxes[i].max.data(), 24);
  }
  CoordinateArrays<double, 3> arrays;
  arrays.count = bodies.size();
  const auto* first = reinterpret_cast<const std::byte*>(bodies.data());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    arrays.min[axis] = {reinterpret_cast<const double*>(first + offsetof(Body, low) + 8 * axis),
                        sizeof(Body)};
    arrays.max[axis] = {reinterpret_cast<const double*>(first + offsetof(Body, high) + 8 * axis),
                        sizeof(Body)};
  }
  EXPECT_EQ(*find_pairs(arrays), true_pairs(boxes));
}

TEST(BoxView, OfOneBoxManyTimesHasAStrideOfZero) {
  const Box<float, 2> box = {{0, 0}, {1, 1}};
  CoordinateArrays<float, 2> arrays;
  arrays.count = 5;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    arrays.min[axis] = {&box.min[axis], 0};
    arrays.max[axis] = {&box.max[axis], 0};
  }
  EXPECT_EQ(*count_pairs(arrays), 10U);
}

TEST(BoxView, TakesSpansArraysAndVectors) {
  const std::array<Aabb, 2> array = {};
  const std::vector<Box<float, 3>> vector(2);
  EXPECT_EQ(*count_pairs(array), 1U);
  EXPECT_EQ(*count_pairs(std::span<const Aabb>(array)), 1U);
  EXPECT_EQ(*count_pairs(array, vector), 4U) << "an Aabb is a box of three floats";
  static_assert(!std::is_constructible_v<BoxView, std::vector<int>>);
  static_assert(!std::is_constructible_v<BoxView, std::vector<Box<int, 3>>>);
}

}  // namespace
}  // namespace cellsweep::one_shot
