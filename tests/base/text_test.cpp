/// @file
/// Messages from words and numbers.
#include "base/text.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>

namespace cellsweep {
namespace {

TEST(Text, PutsWordsAndNumbersSideBySide) {
  EXPECT_EQ(text("There are ", 3, " of ", std::uint64_t{1} << 40, '.'), "There are 3 of 1099511627776.");
}

TEST(Text, HasDigitsEnoughToTellFloatsApart) {
  for (const float value : {0.1F, 1.0F / 3, 16777217.0F, 3.4028235e38F, 1.17549435e-38F}) {
    EXPECT_EQ(std::strtof(text(value).c_str(), nullptr), value);
  }
  EXPECT_EQ(text(0.5F), "0.5");
}

}  // namespace
}  // namespace cellsweep
