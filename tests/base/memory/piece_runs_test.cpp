/// @file
/// Runs of pieces: none in another one, and what was given back is there for the next.
#include "base/memory/piece_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "world/random.h"

namespace cellsweep {
namespace {

constexpr std::uint32_t kAll = PieceRuns::kPieces;
constexpr std::uint32_t kPage = PieceRuns::kPiecesOfPage;

TEST(PieceRuns, GetTheFirstPlaceThatIsLongEnough) {
  PieceRuns runs;
  EXPECT_EQ(runs.take(3, 1), 0U);
  EXPECT_EQ(runs.take(4, 1), 3U);
  EXPECT_EQ(runs.take(1, 1), 7U);
  runs.give(3);
  EXPECT_EQ(runs.take(5, 1), 8U) << "four are free before";
  EXPECT_EQ(runs.take(2, 1), 3U);
  EXPECT_EQ(runs.take(2, 1), 5U);
}

TEST(PieceRuns, BeginWhereTheyAreAskedTo) {
  PieceRuns runs;
  EXPECT_EQ(runs.take(1, 1), 0U);
  EXPECT_EQ(runs.take(kPage, kPage), kPage);
  EXPECT_EQ(runs.take(kPage - 1, 1), 1U) << "what was left out before it";
}

TEST(PieceRuns, HaveNoRoomForMoreThanThereIs) {
  PieceRuns runs;
  EXPECT_EQ(runs.take(kAll + 1, 1), kAll);
  EXPECT_EQ(runs.take(kAll, 1), 0U);
  EXPECT_EQ(runs.take(1, 1), kAll);
  runs.give(0);
  EXPECT_EQ(runs.take(kAll, 1), 0U) << "it was not cut";
}

TEST(PieceRuns, ThatWereGivenBackSideBySideAreOne) {
  PieceRuns runs;
  for (std::uint32_t first = 0; first < kAll; first += 8) ASSERT_EQ(runs.take(8, 1), first);
  for (std::uint32_t first = kAll; first > 0; first -= 8) runs.give(first - 8);
  EXPECT_EQ(runs.take(kAll, 1), 0U);
}

TEST(PieceRuns, GrowWhereThereIsRoomBehindThemAndShrink) {
  PieceRuns runs;
  runs.take(4, 1);
  runs.take(4, 1);
  runs.take(4, 1);
  EXPECT_FALSE(runs.resize(0, 5));
  EXPECT_EQ(runs.end_of(0), 4U);
  runs.give(4);
  EXPECT_FALSE(runs.resize(0, 9));
  EXPECT_TRUE(runs.resize(0, 8));
  EXPECT_EQ(runs.end_of(0), 8U);
  EXPECT_TRUE(runs.resize(0, 1));
  EXPECT_EQ(runs.take(7, 1), 1U);
}

TEST(PieceRuns, LeaveAPageFreeWhereNoPieceOfItIsGivenOut) {
  PieceRuns runs;
  EXPECT_EQ(runs.free_pages(), 0xffffU);
  runs.take(1, 1);
  EXPECT_EQ(runs.free_pages(), 0xfffeU);
  runs.take(kPage, 1);  // into the next one
  EXPECT_EQ(runs.free_pages(), 0xfffcU);
  runs.give(1);
  EXPECT_EQ(runs.free_pages(), 0xfffeU);
}

// Beside a list of what is given out that knows nothing of runs.
TEST(PieceRuns, NeverLieInEachOther) {
  Random random(5);
  PieceRuns runs;
  std::map<std::uint32_t, std::uint32_t> given;  // first piece to end
  const auto is_free = [&](std::uint32_t first, std::uint32_t end) {
    return std::ranges::none_of(given,
                                [&](const auto& run) { return run.first < end && first < run.second; });
  };
  const auto has_room = [&](std::uint32_t pieces, std::uint32_t unit) {
    for (std::uint32_t first = 0; first + pieces <= kAll; first += unit)
      if (is_free(first, first + pieces)) return true;
    return false;
  };
  for (int step = 0; step < 4000; ++step) {
    const bool is_large = random.below(8) == 0;
    const std::uint32_t unit = is_large ? kPage : 1;
    const auto pieces = static_cast<std::uint32_t>(1 + random.below(is_large ? 3 * kPage : 60));
    const std::uint64_t what = random.below(100);
    if (what < 52) {
      const bool fits = has_room(pieces, unit);
      const std::uint32_t first = runs.take(pieces, unit);
      ASSERT_EQ(first < kAll, fits) << step;
      if (!fits) continue;
      ASSERT_EQ(first % unit, 0U);
      ASSERT_TRUE(first + pieces <= kAll && is_free(first, first + pieces)) << step;
      given[first] = first + pieces;
    } else if (!given.empty()) {
      const auto run = std::next(given.begin(), static_cast<long>(random.below(given.size())));
      if (what < 90) {
        runs.give(run->first);
        given.erase(run);
      } else {
        const std::uint32_t end = run->first + pieces;
        const bool fits = end <= kAll && (end <= run->second || is_free(run->second, end));
        ASSERT_EQ(runs.resize(run->first, pieces), fits) << step;
        if (fits) run->second = end;
      }
    }
    std::uint32_t pages = 0;
    for (std::uint32_t page = 0; page < PieceRuns::kPages; ++page)
      if (is_free(page * kPage, (page + 1) * kPage)) pages |= 1U << page;
    ASSERT_EQ(runs.free_pages(), pages) << step;
  }
}

}  // namespace
}  // namespace cellsweep
