/// @file
/// Which boxes of two sets are left out of a search: only such as no pair has, and most of those.
#include "one_shot/apart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "contract/box_kinds.h"
#include "one_shot/sets_of_boxes.h"

namespace cellsweep::one_shot {
namespace {

/// Two sets, and the places of those that are left in.
std::vector<std::uint32_t> places_left(const std::vector<Aabb>& first, const std::vector<Aabb>& second) {
  SearchedBoxes boxes;
  boxes.are_two = true;
  boxes.second = boxes.second_place = static_cast<std::uint32_t>(first.size());
  boxes.own.renew(first.size() + second.size());
  std::copy(second.begin(), second.end(), std::copy(first.begin(), first.end(), boxes.own.data()));
  boxes.boxes = boxes.own.view();
  leave_out_apart(boxes);
  std::vector<std::uint32_t> places(boxes.places.data(), boxes.places.data() + boxes.places.size());
  if (boxes.boxes.size() == first.size() + second.size()) {
    for (std::uint32_t place = 0; place < boxes.boxes.size(); ++place) places.push_back(place);
  }
  EXPECT_EQ(places.size(), boxes.boxes.size());
  const auto end = std::ranges::lower_bound(places, boxes.second_place);
  EXPECT_EQ(end - places.begin(), boxes.second) << "where the second set begins";
  for (std::size_t slot = 0; slot < places.size(); ++slot) {
    const std::uint32_t place = places[slot];
    EXPECT_EQ(boxes.boxes[slot], place < first.size() ? first[place] : second[place - boxes.second_place]);
  }
  return places;
}

void expect_pairs_left(const contract::BoxKind& kind, std::uint32_t count) {
  contract::Random random(9);
  auto first = contract::make_boxes(kind, random, count);
  auto second = contract::make_boxes(kind, random, count / 2);
  for (auto* boxes : {&first, &second}) {
    for (Aabb& box : *boxes) box = contract::canonical_box(box);
  }
  const auto left = places_left(first, second);
  for (const CrossPair pair : true_pairs(first, second)) {
    ASSERT_TRUE(std::ranges::binary_search(left, pair.a)) << kind;
    ASSERT_TRUE(std::ranges::binary_search(left, count + pair.b)) << kind;
  }
}

/// Tiny cubes in a world of 64 cells on an axis, corners on the borders of cells or anywhere; on the first
/// axis only in each eighth cell from `first_cell` on.
std::vector<Aabb> tiny_cubes(contract::Random& random, std::size_t count, std::uint64_t first_cell,
                             float origin, float edge) {
  std::vector<Aabb> boxes(count);
  for (Aabb& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto cell = static_cast<float>(axis == 0 ? first_cell + 8 * random.below(8) : random.below(64));
      const float offset = random.one_in(2) ? 0 : static_cast<float>(random.below(1000)) / 1000;
      box.min[axis] = origin + (cell + offset) * edge;
      box.max[axis] = box.min[axis] + edge / 16;
    }
  }
  return boxes;
}

// Few of either set are near the other, so that the grid is asked.
TEST(Apart, LeavesInWhateverHasAPairAmongManyThatHaveNone) {
  contract::Random random(3);
  for (const float origin : {0.0F, -32.0F, 1e6F, -1e-3F}) {
    for (const float edge : {1.0F, 1e-4F}) {
      const auto first = tiny_cubes(random, 2000, 0, origin, edge);
      auto second = tiny_cubes(random, 1000, 4, origin, edge);
      for (std::size_t i = 0; i < 12; ++i) {
        Aabb& box = second[5 + i * 71] = first[5 + i * 91];
        if (i % 2 == 0) continue;
        box.min[i % 3] = box.max[i % 3];  // they touch at a face
        box.max[i % 3] += edge / 16;
      }
      const auto left = places_left(first, second);
      for (const CrossPair pair : true_pairs(first, second)) {
        ASSERT_TRUE(std::ranges::binary_search(left, pair.a)) << origin << " " << edge;
        ASSERT_TRUE(std::ranges::binary_search(left, 2000 + pair.b)) << origin << " " << edge;
      }
      const bool are_points = origin + edge / 16 == origin;
      EXPECT_TRUE(are_points || left.size() < 300) << left.size() << " at " << origin << " " << edge;
    }
  }
}

TEST(Apart, LeavesInAllOfTwoSetsThatLieMixed) {
  std::vector<Aabb> first, second;
  for (int i = 0; i < 3000; ++i) {
    const auto x = static_cast<float>(i % 10), y = static_cast<float>(i / 10 % 10),
               z = static_cast<float>(i / 100);
    (i % 2 == 0 ? first : second).push_back({{x, y, z}, {x + 1.2F, y + 1.2F, z + 1.2F}});
  }
  EXPECT_EQ(places_left(first, second).size(), 3000U);
}

// Of few boxes by the bounds of the sets.
TEST(Apart, LeavesInWhateverHasAPair) {
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    for (const std::uint32_t count : {400U, 1600U}) expect_pairs_left(kind, count);
  }
}

TEST(Apart, LeavesOutAllOfSetsThatLieApart) {
  const std::vector<Aabb> first(50, Aabb{{0, 0, 0}, {1, 1, 1}});
  const std::vector<Aabb> second(50, Aabb{{2, 0, 0}, {3, 1, 1}});
  EXPECT_TRUE(places_left(first, second).empty());
}

TEST(Apart, LeavesOutMostOfTwoSetsThatAreInterlaced) {
  std::vector<Aabb> first, second;
  for (int i = 0; i < 1200; ++i) {
    const auto x = static_cast<float>(i % 10), y = static_cast<float>(i / 10 % 10),
               z = static_cast<float>(i / 100);
    first.push_back({{x, y, z}, {x + 0.3F, y + 0.3F, z + 0.3F}});
    second.push_back({{x + 0.5F, y + 0.5F, z + 0.5F}, {x + 0.8F, y + 0.8F, z + 0.8F}});
  }
  second[0] = first[999];
  EXPECT_LT(places_left(first, second).size(), 20U) << "their bounds are nearly the same";
}

TEST(Apart, GivesUpTheGridWhereBoxesAreLarge) {
  const std::vector<Aabb> first(3000, Aabb{{0, 0, 0}, {1, 1, 1}});
  std::vector<Aabb> second = first;
  second.resize(6000, Aabb{{5, 5, 5}, {6, 6, 6}});
  EXPECT_EQ(places_left(first, second).size(), 6000U) << "those beyond the first set's bounds are left out";
}

}  // namespace
}  // namespace cellsweep::one_shot
