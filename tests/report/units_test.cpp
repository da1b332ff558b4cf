#include "report/units.h"

#include <gtest/gtest.h>

namespace cellsweep::report {
namespace {

TEST(TimeText, HasThreeDigitsAndTheUnitThatFits) {
  EXPECT_EQ(time_text(0.2149), "0.215 µs");
  EXPECT_EQ(time_text(8.5), "8.50 µs");
  EXPECT_EQ(time_text(99.96), "100 µs");
  EXPECT_EQ(time_text(999.6), "1.00 ms");
  EXPECT_EQ(time_text(27'140), "27.1 ms");
  EXPECT_EQ(time_text(5.88e6), "5.88 s");
  EXPECT_EQ(time_text(0), "0.00 µs");
  EXPECT_EQ(time_text(-27'140), "-27.1 ms");
}

TEST(DurationText, IsTheSameOfMilliseconds) {
  EXPECT_EQ(duration_text(186.4), "186 ms");
  EXPECT_EQ(duration_text(3.617), "3.62 ms");
  EXPECT_EQ(duration_text(0.0085), "8.50 µs");
  EXPECT_EQ(duration_text(0.5), "500 µs");
  EXPECT_EQ(duration_text(5880), "5.88 s");
}

TEST(CountText, HasCommas) {
  EXPECT_EQ(count_text(64), "64");
  EXPECT_EQ(count_text(1024), "1,024");
  EXPECT_EQ(count_text(1048576), "1,048,576");
}

TEST(FactorText, HasThreeDigits) {
  EXPECT_EQ(factor_text(1.213), "1.21");
  EXPECT_EQ(factor_text(0.8312), "0.831");
  EXPECT_EQ(factor_text(2169), "2169");
}

}  // namespace
}  // namespace cellsweep::report
