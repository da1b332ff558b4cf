/// @file
/// Three lists of numbers sorted at once, beside std::sort.
#include "engines/stream/cells/lane_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "contract/random.h"

namespace cellsweep::stream {
namespace {

TEST(LaneSort, SortsEachLaneByItselfWhateverTheCount) {
  contract::Random random(1);
  for (std::size_t count = 0; count <= 140; ++count) {
    std::vector<Float4> numbers(count);
    for (Float4& lanes : numbers) {
      lanes = Float4{random.between(-1, 1), static_cast<float>(random.below(5)), random.between(0, 1e30F), 0};
    }
    std::vector<Float4> sorted = numbers;
    sort_lanes(sorted);
    for (int lane = 0; lane < 3; ++lane) {
      std::vector<float> expected, found;
      for (const Float4& lanes : numbers) expected.push_back(lanes[lane]);
      for (const Float4& lanes : sorted) found.push_back(lanes[lane]);
      std::ranges::sort(expected);
      EXPECT_EQ(found, expected) << count << " numbers, lane " << lane;
    }
  }
}

}  // namespace
}  // namespace cellsweep::stream
