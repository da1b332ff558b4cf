/// @file
/// Numbers from anywhere, in order.
#include "base/sorting/key_sort.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "base/memory/starved.h"
#include "cellsweep/pair.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using testing::ElementsAreArray;
using Keys = std::vector<std::uint64_t>;

unsigned bits_of(std::uint64_t number) {
  return static_cast<unsigned>(std::bit_width(number));
}

/// In place, into either of two arrays, and as two numbers of whatever many bits.
void expect_sorted(const Keys& keys) {
  Keys expected = keys;
  std::ranges::sort(expected);
  Keys here = keys;
  sort_keys(here);
  ASSERT_EQ(here, expected) << keys.size() << " keys";
  Keys spare(keys.size());
  here = keys;
  ASSERT_THAT(sort_keys(here, spare), ElementsAreArray(expected)) << keys.size() << " keys";
  const unsigned bits = expected.empty() ? 0 : bits_of(expected.back());
  for (const unsigned second : {0U, 1U, bits / 3, bits / 2, bits}) {
    here = keys;
    const unsigned lower = std::min(second, bits);
    ASSERT_THAT(sort_keys(here, spare, {bits - lower, lower}), ElementsAreArray(expected))
        << keys.size() << " keys, second numbers of " << lower << " of " << bits << " bits";
  }
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

TEST(SortKeys, SortsPairsOfWhichManyHaveTheFirstInCommon) {
  Random random(3);
  for (const std::size_t count : {30, 700, 3000, 40'000}) {
    for (const std::uint64_t firsts : {1, 2, 100, 5000}) {
      Keys keys(count);
      for (std::uint64_t& key : keys)
        key = mix64(random.below(firsts)) >> 40 << 32 | static_cast<std::uint32_t>(random.bits());
      expect_sorted(keys);
    }
  }
}

TEST(SortKeys, SortsThoseThatDifferInAnyNumberOfBits) {
  Random random(4);
  for (unsigned bits = 0; bits <= 64; ++bits) {
    Keys keys(random.below(3000));
    for (std::uint64_t& key : keys) key = bits == 0 ? 0 : random.bits() >> (64 - bits);
    expect_sorted(keys);
  }
}

TEST(SortKeys, WithoutMemoryHasDoneNothing) {
  Keys keys(1000);
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = mix64(i);
  const Keys before = keys;
  ASSERT_TRUE(fails_at(1, [&] { sort_keys(keys); }));
  EXPECT_EQ(keys, before);
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
