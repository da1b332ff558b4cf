/// @file
/// Where each of some kinds begins, of which there are so many.
#include "base/sorting/prefix_sums.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>
#include <vector>

#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;

TEST(PrefixSums, AreThoseOfTheStandardLibraryForAnyLength) {
  Random random(1);
  for (std::size_t length = 0; length < 70; ++length) {
    std::vector<std::uint32_t> counts(length);
    for (std::uint32_t& count : counts) count = static_cast<std::uint32_t>(random.below(1'000));
    std::vector<std::uint32_t> expected(length);
    std::exclusive_scan(counts.begin(), counts.end(), expected.begin(), std::uint32_t{0});
    make_prefix_sums(counts);
    EXPECT_EQ(counts, expected) << length;
  }
}

TEST(PrefixSums, WriteNothingBehindTheLast) {
  std::vector<std::uint32_t> counts(11, 3);
  make_prefix_sums(std::span(counts).first(7));
  EXPECT_EQ(counts, (std::vector<std::uint32_t>{0, 3, 6, 9, 12, 15, 18, 3, 3, 3, 3}));
}

}  // namespace
}  // namespace cellsweep
