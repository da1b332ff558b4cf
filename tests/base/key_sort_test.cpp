/// @file
/// Numbers from anywhere, in order.
#include "base/key_sort.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "cellsweep/pair.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using Keys = std::vector<std::uint64_t>;

void expect_sorted(Keys keys) {
  Keys expected = keys;
  std::ranges::sort(expected);
  sort_keys(keys);
  EXPECT_EQ(keys, expected) << keys.size() << " keys";
}

TEST(SortKeys, SortsAnyNumberFromAnywhere) {
  for (const std::size_t count : {0, 1, 2, 23, 24, 25, 100, 255, 256, 257, 1000, 20'000}) {
    Keys keys(count);
    for (std::size_t i = 0; i < count; ++i) keys[i] = mix64(i + count);
    expect_sorted(keys);
  }
}

TEST(SortKeys, SortsThoseThatCrowdTogetherButForAFew) {
  Random random(2);
  for (const std::uint64_t crowd : {1, 2, 10, 100'000}) {
    Keys keys(3000);
    for (std::uint64_t& key : keys) key = 500 + random.below(crowd);
    expect_sorted(keys);
    keys[7] = std::numeric_limits<std::uint64_t>::max();
    keys[8] = 0;
    expect_sorted(keys);
  }
}

TEST(SortKeys, SortsThoseThatAreSortedOneWayOrTheOther) {
  Keys keys(5000);
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = i * 7'000'000'000;
  expect_sorted(keys);
  std::ranges::reverse(keys);
  expect_sorted(keys);
}

}  // namespace
}  // namespace cellsweep
