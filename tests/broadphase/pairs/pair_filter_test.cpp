/// @file
/// What filters leave of the pairs that an engine found, in the order that an engine's pairs have.
#include "broadphase/pairs/pair_filter.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <span>
#include <vector>

#include "base/pairs/pair_of.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::uint64_t> keys_of(std::span<const SlotPair> pairs) {
  std::vector<std::uint64_t> keys;
  for (const SlotPair& pair : pairs) keys.push_back(pair_key(pair));
  return keys;
}

std::uint64_t key(Slot a, Slot b) {
  return pair_key(SlotPair{a, b});
}

/// Filters of six slots, of which some were left for others.
class PairFilterTest : public testing::Test {
 protected:
  PairFilterTest() { filters_.reserve(8, 8); }

  void make_static(Slot slot) { filters_.set(slot, {.is_static = true}); }

  SlotFilters filters_;
  PairFilter filter_;
};

TEST_F(PairFilterTest, LeavesOutPairsOfStaticBodies) {
  make_static(1);
  make_static(2);
  const std::vector<SlotPair> began{{0, 1}, {1, 2}, {2, 3}};
  const std::vector<std::uint64_t> more{key(1, 2), key(3, 4)};
  const std::span<const std::uint64_t> part = more;
  const FoundPairs left = filter_.apply({.began = began, .more_began = {&part, 1}}, filters_);
  EXPECT_THAT(keys_of(left.began), ElementsAre(key(0, 1), key(2, 3)));
  EXPECT_THAT(left.ended, IsEmpty());
  ASSERT_EQ(left.more_began.size(), 1U);
  EXPECT_THAT(left.more_began[0], ElementsAre(key(3, 4)));
}

TEST_F(PairFilterTest, TellsNothingOfAPairThatFollowedItsBodyToAnotherSlot) {
  filters_.move(1, 6);
  const std::vector<SlotPair> began{{0, 6}};
  const std::vector<SlotPair> ended{{0, 1}};
  const FoundPairs left = filter_.apply({.began = began, .ended = ended, .is_filtered = true}, filters_);
  EXPECT_THAT(left.began, IsEmpty());
  EXPECT_THAT(left.ended, IsEmpty());
  EXPECT_THAT(left.more_began, IsEmpty());
}

// By the slots that bodies have now, (3, 6) comes before (3, 7), and both before (4, 5).
TEST_F(PairFilterTest, KeepsWhatEndedInTheOrderOfTheSlotsInWhichItEnded) {
  filters_.move(1, 7);
  filters_.move(2, 6);
  const std::vector<SlotPair> ended{{1, 3}, {2, 3}, {4, 5}};
  const FoundPairs left = filter_.apply({.ended = ended, .is_filtered = true}, filters_);
  EXPECT_THAT(keys_of(left.ended), ElementsAre(key(1, 3), key(2, 3), key(4, 5)));
}

}  // namespace
}  // namespace cellsweep
