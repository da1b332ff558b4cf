/// @file
/// How even frames are, of which some were the machine's fault.
#include "bench/peers/even_frames.h"

#include <gmock/gmock.h>

#include <vector>

namespace cellsweep::bench {
namespace {

using testing::DoubleEq;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(MiddleOfRuns, IsWhatAFrameTookInTheMiddleOne) {
  EXPECT_THAT(middle_of({{{1, 2, 3, 3}, {2, 3, 1, 3}, {3, 1, 2, 1}}}), ElementsAre(2, 2, 2, 3));
  EXPECT_THAT(middle_of({}), IsEmpty());
}

TEST(MiddleOfRuns, LeavesOutWhatOneRunWasDisturbedIn) {
  EXPECT_THAT(middle_of({{{1, 9, 1}, {9, 1, 1}, {1, 1, kDisturbed}}}), ElementsAre(1, 1, 1));
}

TEST(MiddleOfRuns, KeepsWhatTakesLongEachTime) {
  EXPECT_THAT(middle_of({{{1, 5, 1}, {1, 6, 1}, {1, 7, 1}}}), ElementsAre(1, 6, 1));
}

TEST(MiddleOfRuns, HasNoFrameThatWasDisturbedTwice) {
  EXPECT_THAT(middle_of({{{1, kDisturbed}, {1, kDisturbed}, {1, 2}}}), ElementsAre(1));
}

TEST(OverMediansNearby, OfAWorldThatTakesLessAndLessAreEven) {
  std::vector<double> frames;
  for (int i = 0; i < 1000; ++i) frames.push_back(2000 - i);
  EXPECT_THAT(over_medians_nearby(frames), Each(testing::DoubleNear(1, 0.06)));
}

TEST(OverMediansNearby, TellsWhatTakesLongerThanThoseAround) {
  std::vector<double> frames(300, 2);
  frames[0] = frames[150] = frames[299] = 6;
  const std::vector<double> ratios = over_medians_nearby(frames);
  ASSERT_EQ(ratios.size(), frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_THAT(ratios[i], DoubleEq(frames[i] / 2)) << i;
}

TEST(OverMediansNearby, OfFewFramesAreOverTheMedianOfAll) {
  EXPECT_THAT(over_medians_nearby(std::vector<double>{1, 2, 4}), ElementsAre(0.5, 1, 2));
  EXPECT_THAT(over_medians_nearby({}), IsEmpty());
}

}  // namespace
}  // namespace cellsweep::bench
