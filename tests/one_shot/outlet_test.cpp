/// @file
/// Where pairs go: no more candidates of rounded boxes are looked at than is worth it.
#include "one_shot/outlet.h"

#include <gtest/gtest.h>

#include "one_shot/sets_of_boxes.h"

namespace cellsweep::one_shot {
namespace {

TEST(Outlet, GivesUpWhereFarMoreCandidatesComeThanOverlap) {
  // Box 0 overlaps box 1 and nothing else.
  std::vector<ExactBox> exact(100, ExactBox{{5, 5, 5}, {6, 6, 6}});
  exact[0] = exact[1] = {{0, 0, 0}, {1, 1, 1}};
  const SearchedBoxes boxes;
  Found found;
  found.boxes = &boxes;
  found.exact = exact.data();
  found.most_candidates = 40;
  CountOutlet outlet(found);
  const std::uint64_t pair = pair_key(Pair{0, 1});
  outlet.write({&pair, 1});
  for (std::uint32_t other = 2; other < 43; ++other) {
    const std::uint64_t key = pair_key(Pair{0, other});
    outlet.write({&key, 1});
  }
  outlet.flush();
  EXPECT_EQ(found.pairs, 1U);
  EXPECT_EQ(found.candidates, 41U) << "one more for the pair that is one";
  const std::uint64_t last = pair_key(Pair{1, 99});
  outlet.write({&last, 1});
  EXPECT_THROW(outlet.flush(), TooManyCandidates);
}

TEST(Outlet, HandsOnMoreThanItHolds) {
  const SearchedBoxes boxes;
  Found found;
  found.boxes = &boxes;
  ListOutlet outlet(found);
  std::vector<std::uint64_t> keys(10'000);
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = i;
  outlet.write(keys);
  outlet.flush();
  EXPECT_TRUE(std::ranges::equal(outlet.view(), keys));
  EXPECT_EQ(found.pairs, keys.size());
}

}  // namespace
}  // namespace cellsweep::one_shot
