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

TEST(Table, CountsCharactersAndNotBytes) {
  Table table({"name", "time"});
  table.add({"a", "8.50 µs"});
  table.add({"b", "9.99 ms"});
  EXPECT_EQ(table.text(),
            "name     time\n"
            "----  -------\n"
            "a     8.50 µs\n"
            "b     9.99 ms\n");
}

}  // namespace
}  // namespace cellsweep::report
