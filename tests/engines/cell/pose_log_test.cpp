/// @file
/// Which poses cell-resident's SPUs are told, and how they are laid out for them.
#include "engines/cell/ppu/pose_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cellsweep::cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

BodyPose at(float x) {
  BodyPose pose;
  pose.centre = {x, 10 * x, 100 * x};
  pose.half_extents = {1, 2, 3};
  return pose;
}

TEST(PoseLog, ABodyIsListedOnceWithItsLastPose) {
  PoseLog log;
  log.set(3, at(1));
  log.set(0, at(2));
  log.set(3, at(4));
  EXPECT_THAT(log.pending(), ElementsAre(3, 0));
  std::vector<PoseBlock> blocks(1);
  log.pack(blocks);
  EXPECT_EQ(blocks[0].centre[0][0], 4);
  EXPECT_EQ(blocks[0].centre[2][1], 200);
  EXPECT_EQ(blocks[0].half_extents[1][0], 2);
  EXPECT_EQ(blocks[0].orientation[3][3], 1) << "a lane without a body holds a good quaternion";
}

TEST(PoseLog, APoseThatWasToldIsNotListedAgain) {
  PoseLog log;
  log.set(1, at(1));
  log.clear_pending();
  log.set(1, at(1));
  EXPECT_THAT(log.pending(), IsEmpty());
  log.set(1, at(2));
  EXPECT_THAT(log.pending(), ElementsAre(1));
}

TEST(PoseLog, AForgottenBodyIsNeitherListedNorRemembered) {
  PoseLog log;
  log.set(1, at(1));
  log.forget(1);
  log.forget(7);
  EXPECT_THAT(log.pending(), IsEmpty());
  log.set(1, at(1));
  EXPECT_THAT(log.pending(), ElementsAre(1));
}

}  // namespace
}  // namespace cellsweep::cell
