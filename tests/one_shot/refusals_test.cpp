/// @file
/// What one-shot searches refuse, and what they say then.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "one_shot/sets_of_boxes.h"

namespace cellsweep::one_shot {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Every function, so that none forgets to ask.
template <class... Sets>
std::vector<Status> statuses(const FindPairsOptions& options, const Sets&... sets) {
  const auto nobody_comes = [](auto) { ADD_FAILURE() << "a pair of a call that is refused"; };
  return {find_pairs(sets..., options).status(), count_pairs(sets..., options).status(),
          visit_pairs(sets..., nobody_comes, options)};
}

TEST(FindPairsRefuses, BoxesThatAreNone) {
  std::vector<Box<float, 3>> boxes(20);
  boxes[3].min[1] = 2;
  boxes[7].max[2] = std::numeric_limits<float>::quiet_NaN();
  for (const Status& status : statuses({}, boxes)) {
    EXPECT_EQ(status.code, StatusCode::invalid_box);
    EXPECT_THAT(status.bodies, ElementsAre(3U, 7U));
    EXPECT_EQ(status.body, BodyId{3});
    EXPECT_EQ(status.number, 2U);
    EXPECT_EQ(
        status.message,
        "Box 3 is refused: its minimum on y, 2, is above its maximum, 0; box 7: its z interval [0, nan] "
        "is not finite.");
  }
}

TEST(FindPairsRefuses, BoxesOfDoublesWithTheDigitsThatItTakes) {
  std::vector<Box<double, 2>> good(4);
  auto bad = good;
  bad[2] = {{0, 1.0000000000000002}, {1, 1}};
  for (const Status& status : statuses({}, good, bad)) {
    EXPECT_EQ(status.code, StatusCode::invalid_box);
    EXPECT_EQ(
        status.message,
        "Box 2 of the second set is refused: its minimum on y, 1.0000000000000002, is above its maximum, "
        "1.");
  }
  EXPECT_THAT(find_pairs(bad, good).status().message, HasSubstr("Box 2 of the first set"));
  bad[2].max[0] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(find_pairs(bad).status().message, HasSubstr("its x interval [0, inf] is not finite"));
}

TEST(FindPairsRefuses, ManyBoxesByTheFirstOfThem) {
  std::vector<Aabb> boxes(100, Aabb{{1, 0, 0}, {0, 0, 0}});
  const Status status = find_pairs(boxes).status();
  EXPECT_EQ(status.number, 100U);
  EXPECT_EQ(status.bodies.size(), Status::kMostBodies);
  EXPECT_THAT(status.message, HasSubstr("; and 84 more"));
}

TEST(FindPairsRefuses, CoordinatesWithoutAnAddress) {
  const std::vector<float> zeros(5);
  CoordinateArrays<float, 2> arrays;
  arrays.count = 5;
  arrays.min = {{{zeros.data()}, {zeros.data()}}};
  arrays.max = {{{zeros.data()}, {}}};
  for (const Status& status : statuses({}, arrays)) {
    EXPECT_EQ(status.code, StatusCode::bad_input);
    EXPECT_THAT(status.message, AllOf(HasSubstr("maxima on y"), HasSubstr("5 boxes")));
  }
  arrays.count = 0;
  EXPECT_TRUE(find_pairs(arrays).ok()) << "there is nothing to read";
}

TEST(FindPairsRefuses, SetsOfDifferentKinds) {
  const std::vector<Box<float, 2>> flat(1);
  const std::vector<Box<float, 3>> deep(1);
  const std::vector<Box<double, 3>> fine(1);
  for (const Status& status : statuses({}, flat, deep)) {
    EXPECT_EQ(status.code, StatusCode::bad_input);
    EXPECT_THAT(status.message, AllOf(HasSubstr("2 axes of floats"), HasSubstr("3 of floats")));
  }
  EXPECT_THAT(find_pairs(deep, fine).status().message, HasSubstr("3 of doubles"));
}

TEST(FindPairsRefuses, MoreBoxesThanThereAreSlots) {
  const float zero = 0;
  CoordinateArrays<float, 2> arrays;
  arrays.min = arrays.max = {{{&zero, 0}, {&zero, 0}}};
  arrays.count = std::size_t{1} << 29;
  const std::vector<Box<float, 2>> one(1);
  for (const Status& status : statuses({}, arrays)) {
    EXPECT_EQ(status.code, StatusCode::capacity);
    EXPECT_EQ(status.number, std::uint64_t{1} << 29);
    EXPECT_EQ(status.limit, (std::uint64_t{1} << 29) - 1);
  }
  --arrays.count;
  EXPECT_EQ(find_pairs(arrays, one).status().code, StatusCode::capacity) << "both sets together";
  arrays.count = std::numeric_limits<std::size_t>::max();
  EXPECT_EQ(find_pairs(arrays, one).status().code, StatusCode::capacity) << "the sum is no number";
}

TEST(FindPairsRefuses, OptionsOutOfTheirRange) {
  const std::vector<Aabb> boxes(2);
  for (const Status& status : statuses({.threads = 1025}, boxes)) {
    EXPECT_EQ(status.code, StatusCode::bad_option);
    EXPECT_EQ(status.setting, "threads");
  }
  for (const Status& status : statuses({.isa = static_cast<VectorIsa>(77)}, boxes, boxes)) {
    EXPECT_EQ(status.code, StatusCode::bad_option);
    EXPECT_EQ(status.setting, "isa");
  }
}

TEST(FindPairsRefuses, MorePairsThanAreAllowed) {
  for (const std::size_t size : {40, 150, 2500}) {
    const auto boxes = double_kinds()[0].make(size, 1);
    const std::uint64_t pairs = true_pairs(boxes).size();
    ASSERT_GT(pairs, 1U);
    for (const unsigned threads : {1U, 4U}) {
      EXPECT_EQ(find_pairs(boxes, {.threads = threads, .max_pairs = pairs})->size(), pairs);
      EXPECT_EQ(*count_pairs(boxes, {.threads = threads, .max_pairs = pairs}), pairs);
      const FindPairsOptions options{.threads = threads, .max_pairs = pairs - 1};
      std::uint64_t seen = 0;
      for (const Status& status : {find_pairs(boxes, options).status(), count_pairs(boxes, options).status(),
                                   visit_pairs(
                                       boxes, [&](Pair) { ++seen; }, options)}) {
        EXPECT_EQ(status.code, StatusCode::capacity);
        EXPECT_EQ(status.setting, "max_pairs");
        EXPECT_EQ(status.limit, pairs - 1);
        EXPECT_EQ(status.number, pairs);
      }
      EXPECT_EQ(seen, pairs - 1);
    }
  }
}

}  // namespace
}  // namespace cellsweep::one_shot
