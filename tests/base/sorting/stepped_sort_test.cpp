/// @file
/// Keys that are sorted a part at a time.
#include "base/sorting/stepped_sort.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

#include "base/memory/starved.h"
#include "cellsweep/pair.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using testing::ElementsAreArray;
using Keys = std::vector<std::uint64_t>;

List<std::uint64_t> list_of(const Keys& keys) {
  List<std::uint64_t> list;
  list.reserve(keys.size());
  for (const std::uint64_t key : keys) list.push(key);
  return list;
}

/// In parts of so many steps. Returns how many steps it took.
std::size_t expect_sorted(SteppedSort& sort, Keys keys, std::size_t part) {
  List<std::uint64_t> list = list_of(keys);
  sort.begin(list);
  EXPECT_TRUE(list.empty());
  std::size_t taken = 0;
  for (bool is_done = false; !is_done;) {
    std::size_t steps = part;
    is_done = sort.go_on(steps);
    taken += part - steps;
    EXPECT_TRUE(is_done || steps == 0) << "a part that was left";
  }
  std::ranges::sort(keys);
  EXPECT_THAT(sort.keys(), ElementsAreArray(keys));
  return taken;
}

Keys random_keys(std::size_t count, unsigned bits) {
  Random random(count + bits);
  Keys keys(count);
  for (std::uint64_t& key : keys) key = random.bits() >> (64 - bits);
  return keys;
}

TEST(SteppedSort, SortsAnyKeysInPartsOfAnySize) {
  SteppedSort sort;
  for (const std::size_t count : {0, 1, 2, 100, 2048, 5000}) {
    for (const unsigned bits : {1U, 12U, 40U, 64U}) {
      for (const std::size_t part : {1, 7, 1000, 1'000'000})
        expect_sorted(sort, random_keys(count, bits), part);
    }
  }
}

TEST(SteppedSort, TakesAStepForEachKeyAndForEachDigitThatTheyDifferIn) {
  SteppedSort sort;
  EXPECT_EQ(expect_sorted(sort, Keys(1000, 7), 10), 1000U);
  EXPECT_EQ(expect_sorted(sort, random_keys(1000, 11), 10), 2000U);
  EXPECT_EQ(expect_sorted(sort, random_keys(1000, 64), 10), 7000U);
}

TEST(SteppedSort, WithoutMemoryHasTakenNothingUp) {
  const Keys keys = random_keys(3000, 64);
  struct State {
    List<std::uint64_t> list;
    SteppedSort sort;
  };
  const auto places = starve(
      [&] {
        return State{list_of(keys), {}};
      },
      [](State& state) { state.sort.begin(state.list); },
      [&](State& state) { EXPECT_THAT(state.list.view(), ElementsAreArray(keys)); },
      [&](State& state) {
        std::size_t steps = 1'000'000;
        EXPECT_TRUE(state.sort.go_on(steps));
        EXPECT_TRUE(std::ranges::is_sorted(state.sort.keys()));
        EXPECT_EQ(state.sort.keys().size(), keys.size());
      });
  EXPECT_EQ(places, 2U);
}

}  // namespace
}  // namespace cellsweep
