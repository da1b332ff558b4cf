/// @file
/// Engine `stream` on recorded scenes: the pairs that all-against-all finds, by count and hash.
#include <gtest/gtest.h>

#include "cellsweep/broadphase.h"
#include "frames.h"

namespace cellsweep::stream {
namespace {

TEST(StreamOnRecordings, GivesTheKnownPairsOfThePile) {
  Broadphase broadphase;
  expect_recorded_frames(
      broadphase, "pile",
      {{0, 5577, 0x875cb2208a071dd3}, {15, 4914, 0xadd61a14b776a039}, {30, 3901, 0xc05c583740ead6b9}});
}

TEST(StreamOnRecordings, GivesTheKnownPairsOfTheTowers) {
  Broadphase broadphase;
  expect_recorded_frames(
      broadphase, "towers",
      {{0, 1059, 0x1bd83799cf2eaf2b}, {3, 1665, 0xdf40eae70b24e494}, {5, 2369, 0xd3d6e065474af82e}});
}

}  // namespace
}  // namespace cellsweep::stream
