/// @file
/// When memory goes back.
#include "engines/stream/choices/spare_memory.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

constexpr std::size_t kMuch = 8 * tuning::kFewBytes;
constexpr std::uint32_t kLongWhile = 3 * tuning::kQuietToGiveBack;

/// Updates in which nothing is used until some is to go back; at most kLongWhile.
std::uint32_t updates_until(SpareMemory& memory) {
  for (std::uint32_t update = 0; update < kLongWhile; ++update) {
    if (memory.begin_update()) return update;
  }
  return kLongWhile;
}

TEST(SpareMemory, GoesBackAfterQuietUpdates) {
  SpareMemory memory;
  memory.count(kMuch, 2 * kMuch, 100);
  EXPECT_EQ(updates_until(memory), kLongWhile) << "there is none";
  memory.note_used();
  EXPECT_EQ(updates_until(memory), tuning::kQuietToGiveBack);
  memory.note_tried();
  EXPECT_EQ(updates_until(memory), tuning::kQuietToGiveBack) << "it failed: once more";
  memory.note_given_back();
  EXPECT_EQ(updates_until(memory), kLongWhile);
}

TEST(SpareMemory, StaysWhereItIsUsedOrLittle) {
  SpareMemory memory;
  memory.count(kMuch, 2 * kMuch, 100);
  for (std::uint32_t update = 0; update < kLongWhile; ++update) {
    if (update % tuning::kQuietToGiveBack == 0) memory.note_used();
    EXPECT_FALSE(memory.begin_update());
  }
  memory.note_used();
  memory.count(tuning::kFewBytes, kMuch, 100);
  EXPECT_EQ(updates_until(memory), kLongWhile);
}

TEST(SpareMemory, GoesBackAtOnceWhereTooMuchIsHeld) {
  SpareMemory memory;
  memory.count(kMuch + 1, kMuch, 100);
  EXPECT_TRUE(memory.begin_update());
  memory.count(kMuch, kMuch, 100);
  EXPECT_FALSE(memory.begin_update());
}

TEST(SpareMemory, IsCountedWhereManyChangedOrHalfOfThePairsEnded) {
  SpareMemory memory;
  memory.count(kMuch, kMuch, 100);
  EXPECT_TRUE(memory.is_to_count(false, 100));
  EXPECT_FALSE(memory.is_to_count(true, 50));
  EXPECT_TRUE(memory.is_to_count(true, 49));
}

}  // namespace
}  // namespace cellsweep::stream
