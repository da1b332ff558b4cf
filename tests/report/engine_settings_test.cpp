#include "report/engine_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/hand_over.h"

namespace cellsweep::report {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const SettingValues kMixed = {{"threads", "2"}, {"pair_map_bytes", "4096"}, {"threads", "3"}};

TEST(EngineSettings, GoToTheEnginesThatHaveThem) {
  EXPECT_THAT(values_for("control", kMixed), ElementsAre(testing::Pair("pair_map_bytes", "4096")));
  EXPECT_THAT(values_for("stream", kMixed),
              ElementsAre(testing::Pair("threads", "2"), testing::Pair("threads", "3")));
  EXPECT_THAT(values_for("nosuch", kMixed), IsEmpty());
}

TEST(EngineSettings, AreWhatTheyWereGivenLast) {
  EXPECT_EQ(value_of(kMixed, "threads"), "3");
  EXPECT_EQ(value_of(kMixed, "isa"), "");
}

TEST(EngineSettings, SayWhetherAnEngineTakesPoses) {
  EXPECT_EQ(shape_of(kMixed), Shape::boxes);
  EXPECT_EQ(shape_of({{"spu_boxes", "false"}}), Shape::boxes);
  EXPECT_EQ(shape_of({{"spu_boxes", "true"}}), Shape::poses);
}

}  // namespace
}  // namespace cellsweep::report
