#include "report/experiment/standing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "made_up_results.h"

namespace cellsweep::report {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(Standing, ComparesStreamWithTheFastestOtherAndWithControl) {
  ExperimentResults results = made_up_results();
  set_time(results, "stream", 1024, Measure::median, 10);
  set_time(results, "cell-resident", 1024, Measure::median, 53);
  set_time(results, "control", 1024, Measure::median, 612);
  set_time(results, "cell-paper-spus", 1024, Measure::median, 1);  // a part of a frame is no frame
  EXPECT_EQ(standing_text(results, Measure::median),
            "With 1,024 boxes stream takes 10.0 µs. The fastest of the others is cell-resident with 53.0 µs: "
            "stream is 5.30 times as fast. control takes 612 µs: stream is 61.2 times as fast.");
}

TEST(Standing, SaysSoWhenStreamIsBehind) {
  ExperimentResults results = made_up_results();
  set_time(results, "control", 1024, Measure::still, 50);
  EXPECT_THAT(standing_text(results, Measure::still),
              HasSubstr("is control with 50.0 µs: stream is 2.00 times as slow."));
}

TEST(Standing, IsOfTheLargestSizeThatWasMeasured) {
  ExperimentResults results = made_up_results();
  for (CurveResult& curve : results.curves) curve.points.erase(1024);
  EXPECT_THAT(standing_text(results, Measure::initial), StartsWith("With 512 boxes"));
}

TEST(Standing, IsEmptyWithoutStreamOrWithoutOthers) {
  ExperimentResults no_stream = made_up_results();
  std::erase_if(no_stream.curves, [](const CurveResult& curve) { return curve.curve.engine == "stream"; });
  EXPECT_EQ(standing_text(no_stream, Measure::median), "");
  ExperimentResults only_stream = made_up_results();
  std::erase_if(only_stream.curves, [](const CurveResult& curve) { return curve.curve.engine != "stream"; });
  EXPECT_EQ(standing_text(only_stream, Measure::median), "");
}

}  // namespace
}  // namespace cellsweep::report
