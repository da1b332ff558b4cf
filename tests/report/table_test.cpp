#include "report/table.h"

#include <gtest/gtest.h>

namespace cellsweep::report {
namespace {

TEST(Table, AlignsTheFirstColumnLeftAndTheOthersRight) {
  Table table({"name", "n"});
  table.add({"a", "1024"});
  table.add({"longer", "1"});
  EXPECT_EQ(table.text(),
            "name       n\n"
            "------  ----\n"
            "a       1024\n"
            "longer     1\n");
}

TEST(Table, ShowsNoControlCharacters) {
  Table table({"name"});
  table.add({"pile\033[2J\n"});
  EXPECT_EQ(table.text(), "name\n---------\npile?[2J?\n");
}

TEST(DurationText, KeepsThreeDigitsAndChoosesTheUnit) {
  EXPECT_EQ(duration_text(186.4), "186 ms");
  EXPECT_EQ(duration_text(3.617), "3.62 ms");
  EXPECT_EQ(duration_text(36.17), "36.2 ms");
  EXPECT_EQ(duration_text(0.0085), "8.50 us");
  EXPECT_EQ(duration_text(0.5), "500 us");
  EXPECT_EQ(duration_text(0), "0.00 us");
}

}  // namespace
}  // namespace cellsweep::report
