/// @file
/// How far a rebuild is after each of its updates, where these have more or less to do besides.
#include "engines/stream/rebuild/rebuild_pace.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "contract/random.h"

namespace cellsweep::stream {
namespace {

using Times = std::vector<double>;

/// Updates that take so long besides, many times over; then what the parts of a rebuild of `seconds` take.
Times parts_of(RebuildPace& pace, const Times& besides, double seconds) {
  const auto parts = static_cast<std::uint32_t>(besides.size());
  for (int time = 0; time < 60; ++time) {
    pace.begin(parts, seconds);
    for (std::uint32_t part = 1; part <= parts; ++part) pace.note(part, besides[part - 1]);
  }
  pace.begin(parts, seconds);
  Times times;
  for (std::uint32_t part = 1; part <= parts; ++part)
    times.push_back(seconds * (pace.due(part) - (part > 1 ? pace.due(part - 1) : 0)));
  return times;
}

TEST(RebuildPace, IsEvenAsLongAsNothingIsKnown) {
  RebuildPace pace;
  for (const double seconds : {0.0, 7.0}) {
    pace.begin(7, seconds);
    for (std::uint32_t part = 1; part <= 7; ++part) EXPECT_NEAR(pace.due(part), part / 7.0, 1e-6);
  }
}

TEST(RebuildPace, LeavesAllUpdatesAsLongAsEachOther) {
  const Times besides = {10, 10, 11, 9, 10, 12, 14};
  RebuildPace pace;
  const Times parts = parts_of(pace, besides, 70);
  for (std::size_t i = 0; i < parts.size(); ++i) EXPECT_NEAR(parts[i] + besides[i], 146.0 / 7, 1e-3);
}

TEST(RebuildPace, LeavesAnUpdateThatIsLongByItselfWithoutAPart) {
  RebuildPace pace;
  const Times parts = parts_of(pace, {10, 10, 10, 10, 10, 10, 100}, 60);
  EXPECT_NEAR(parts[6], 0, 1e-3);
  EXPECT_NEAR(parts[0], 10, 1e-3);
}

TEST(RebuildPace, HasAllDueInAnUpdateThatComesTooLate) {
  RebuildPace pace;
  const Times parts = parts_of(pace, {10, 10, 10, 10, 10}, 50);
  for (const std::uint32_t late : {6U, 7U, 100U}) {
    EXPECT_EQ(pace.due(late), 1);
    pace.note(late, 1e6);
  }
  EXPECT_EQ(parts_of(pace, {10, 10, 10, 10, 10}, 50), parts);
}

TEST(RebuildPace, FollowsWhatUpdatesTake) {
  RebuildPace pace;
  parts_of(pace, {100, 10, 10, 10, 10}, 50);
  const Times parts = parts_of(pace, {10, 10, 10, 10, 13}, 50);
  EXPECT_NEAR(parts[0], 10.6, 1e-3);
  EXPECT_NEAR(parts[4], 7.6, 1e-3);
}

TEST(RebuildPace, HasNoPartMuchLongerThanOthersWhateverTheClockSays) {
  contract::Random random(1);
  RebuildPace pace;
  for (int round = 0; round < 300; ++round) {
    const std::size_t parts = 3 + random.below(tuning::kMostForNext - 3);
    Times besides;
    for (std::size_t i = 0; i < parts; ++i) besides.push_back(random.one_in(4) ? 1e6 : random.between(0, 1));
    const double most = RebuildPace::most_of_part(static_cast<std::uint32_t>(parts));
    for (const double part : parts_of(pace, besides, random.one_in(2) ? 1 : 1e-3)) {
      EXPECT_GE(part, 0);
      EXPECT_LE(part, 1.0001 * most / static_cast<double>(parts));
    }
    EXPECT_EQ(pace.due(static_cast<std::uint32_t>(parts)), 1);
  }
}

}  // namespace
}  // namespace cellsweep::stream
