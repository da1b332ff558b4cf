/// @file
/// What the host keeps of the calls between two updates.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engines/cell/ppu/resident_log.h"

namespace cellsweep::cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

Aabb at(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

TEST(ResidentLog, ANewBodyThatMovesIsStillOneNewBody) {
  ResidentLog log;
  log.insert(3, at(0));
  log.move(3, at(1));
  EXPECT_THAT(log.inserted(), ElementsAre(3));
  EXPECT_THAT(log.moved(), IsEmpty());
  EXPECT_EQ(log.box(3), at(1));
}

TEST(ResidentLog, AKnownBodyThatGoesIsNotMovedAnyMore) {
  ResidentLog log;
  log.insert(0, at(0));
  log.clear();
  log.move(0, at(1));
  log.remove(0);
  EXPECT_THAT(log.moved(), IsEmpty());
  EXPECT_THAT(log.removed(), ElementsAre(0));
}

TEST(ResidentLog, ASlotCanLoseABodyAndGetAnother) {
  ResidentLog log;
  log.insert(0, at(0));
  log.clear();
  log.remove(0);
  log.insert(0, at(5));
  EXPECT_THAT(log.removed(), ElementsAre(0));
  EXPECT_THAT(log.inserted(), ElementsAre(0));
  log.remove(0);
  EXPECT_THAT(log.removed(), ElementsAre(0));
  EXPECT_THAT(log.inserted(), IsEmpty());
}

TEST(ResidentLog, AMoveToTheSameBoxIsNoMove) {
  ResidentLog log;
  log.insert(0, at(0));
  log.clear();
  log.move(0, at(0));
  EXPECT_TRUE(log.empty());
}

TEST(ResidentLog, MovingOnAndOnDoesNotMakeTheListGrow) {
  ResidentLog log;
  for (Slot slot = 0; slot < 10; ++slot) log.insert(slot, at(0));
  log.clear();
  for (int round = 1; round < 1000; ++round) {
    for (Slot slot = 0; slot < 10; ++slot) log.move(slot, at(static_cast<float>(round)));
  }
  EXPECT_THAT(log.moved(), SizeIs(testing::Le(40)));
}

}  // namespace
}  // namespace cellsweep::cell
