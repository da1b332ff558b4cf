/// @file
/// Keys of pairs of all widths together with which they may be narrow, against std::sort.
#include "base/sorting/narrow_sort.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/memory/starved.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using Keys = std::vector<std::uint64_t>;

/// Of numbers below 2^first and 2^second, the greatest among them.
Keys keys_below(Random& random, unsigned first, unsigned second, std::size_t count) {
  const std::uint64_t most_first = (std::uint64_t{1} << first) - 1;
  const std::uint64_t most_second = (std::uint64_t{1} << second) - 1;
  std::set<std::uint64_t> keys{most_first << 32 | most_second};
  for (std::size_t i = 1; i < count; ++i)
    keys.insert((random.bits() & most_first) << 32 | (random.bits() & most_second));
  Keys mixed(keys.begin(), keys.end());
  random.shuffle(mixed);
  return mixed;
}

void raise_first_numbers(Keys& keys, std::uint32_t by) {
  for (std::uint64_t& key : keys) key += std::uint64_t{by} << 32;
}

class NarrowSort : public testing::Test {
 protected:
  bool sort(const Keys& keys, std::uint32_t least, std::size_t first_part) {
    const std::span<const std::uint64_t> all = keys;
    const std::span<const std::uint64_t> parts[] = {all.first(first_part), all.subspan(first_part)};
    numbers_.resize(2 * keys.size());
    return sort_narrow_pairs(parts, least, scratch_, numbers_.data());
  }

  bool is_right(Keys keys) const {
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> numbers;
    for (const std::uint64_t key : keys) {
      numbers.push_back(static_cast<std::uint32_t>(key >> 32));
      numbers.push_back(static_cast<std::uint32_t>(key));
    }
    return numbers_ == numbers;
  }

  Random random_{1};
  Array<std::uint64_t> scratch_;
  std::vector<std::uint32_t> numbers_;
};

TEST_F(NarrowSort, IsStdSortForAllWidths) {
  std::size_t sorted = 0;
  for (unsigned first = 0; first <= 32; ++first) {
    for (unsigned second = 0; first + second <= 32; ++second) {
      for (const std::size_t count : {30, 300, 5000}) {
        Keys keys = keys_below(random_, first, second, count);
        const std::uint32_t least = first < 32 ? static_cast<std::uint32_t>(random_.below(0x80000000U)) : 0;
        raise_first_numbers(keys, least);
        if (!sort(keys, least, random_.below(keys.size() + 1))) continue;
        ++sorted;
        ASSERT_TRUE(is_right(keys)) << first << " and " << second << " bits, " << keys.size() << " keys";
      }
    }
  }
  EXPECT_GT(sorted, 800U) << "of 1,683";
}

TEST_F(NarrowSort, IsStdSortWithDigitsOfAllWidths) {
  for (unsigned bits = 10; bits <= 16; ++bits) {
    const Keys keys = keys_below(random_, bits, bits, 40'000);
    ASSERT_TRUE(sort(keys, 0, random_.below(keys.size() + 1)));
    EXPECT_TRUE(is_right(keys)) << bits << " and " << bits << " bits";
  }
}

TEST_F(NarrowSort, LeavesKeysWithMoreBitsAndTooFewKeysAlone) {
  EXPECT_FALSE(sort(keys_below(random_, 16, 17, 5000), 0, 0)) << "33 bits";
  EXPECT_TRUE(sort(keys_below(random_, 16, 16, 5000), 0, 0));
  EXPECT_FALSE(sort(keys_below(random_, 16, 16, 40), 0, 0)) << "256 values of each of four digits";
  EXPECT_FALSE(sort(keys_below(random_, 5, 5, 24), 0, 0)) << "so few are compared";
  EXPECT_FALSE(sort({}, 0, 0));
}

TEST_F(NarrowSort, SucceedsAfterMemoryFailed) {
  const Keys keys = keys_below(random_, 10, 10, 1000);
  numbers_.resize(2 * keys.size());
  const auto sort_them = [&] { sort(keys, 0, 400); };
  EXPECT_TRUE(fails_at(1, sort_them)) << "to work in";
  EXPECT_FALSE(fails_at(2, sort_them)) << "the pairs' is the caller's";
  EXPECT_TRUE(is_right(keys));
}

}  // namespace
}  // namespace cellsweep
