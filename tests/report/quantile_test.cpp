#include "report/quantile.h"

#include <gtest/gtest.h>

#include <numeric>

namespace cellsweep::report {
namespace {

TEST(Quantile, OfNothingIsZero) {
  EXPECT_EQ(quantile({}, 0.5), 0);
}

TEST(Quantile, IsTheSmallestValueThatTheShareDoesNotExceed) {
  EXPECT_EQ(quantile({5, 1, 3}, 0.5), 3);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 1.0), 4);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.0), 1);
}

TEST(Quantile, NinetyNinePercentOfAThousandLeavesTenAbove) {
  std::vector<double> values(1000);
  std::iota(values.begin(), values.end(), 1.0);
  EXPECT_EQ(quantile(values, 0.99), 990);
}

}  // namespace
}  // namespace cellsweep::report
