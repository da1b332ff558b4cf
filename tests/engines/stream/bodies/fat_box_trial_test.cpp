/// @file
/// What a few bodies tell of how long fat boxes would last.
#include "engines/stream/bodies/fat_box_trial.h"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <vector>

#include "base/threads/thread_pool.h"
#include "engines/stream/courses.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

constexpr std::size_t kInMotion = 1000;
constexpr int kUpdatesOnTrial = 40;

class FatBoxTrialTest : public testing::Test {
 protected:
  FatBoxTrialTest() : slots_(kInMotion) { std::iota(slots_.begin(), slots_.end(), Slot{0}); }

  BodyChanges to(const std::vector<Aabb>& boxes) {
    before_ = std::exchange(now_, boxes);
    BodyChanges changes{};
    changes.boxes = now_;
    changes.before = {before_};
    changes.moved = slots_;
    changes.bodies = kInMotion;
    return changes;
  }

  /// The share that a trial tells of boxes that `next(frame)` gives.
  template <class Next>
  double share_while(const Next& next) {
    trial_.begin(to(next(0)));
    for (int frame = 1; frame <= kUpdatesOnTrial; ++frame) EXPECT_TRUE(trial_.go_on(crew_, to(next(frame))));
    EXPECT_EQ(trial_.updates(), static_cast<std::uint32_t>(kUpdatesOnTrial));
    return trial_.share_escaped();
  }

  Crew crew_{std::make_shared<ThreadPool>(1), 1, Crew::Choice::given};
  Courses courses_{kInMotion, 2};
  std::vector<Slot> slots_;
  std::vector<Aabb> before_;
  std::vector<Aabb> now_ = courses_.boxes();
  FatBoxTrial trial_;
};

TEST_F(FatBoxTrialTest, TellsThatFewLeaveThemWhileBodiesKeepTheirCourse) {
  const double share = share_while([&](int) {
    courses_.go_on();
    return courses_.boxes();
  });
  EXPECT_GT(share, 0);
  EXPECT_LT(share, tuning::kMostEscapesOfTried);
}

TEST_F(FatBoxTrialTest, TellsThatNobodyLeavesThemWhileBodiesTremble) {
  const double share = share_while([&](int frame) {
    std::vector<Aabb> boxes = courses_.boxes();
    shake(boxes, 0.02F, static_cast<std::uint64_t>(frame));
    return boxes;
  });
  EXPECT_LT(share, 0.03);
}

TEST_F(FatBoxTrialTest, TellsThatMostLeaveThemWhileBodiesLeap) {
  const double share = share_while(
      [&](int frame) { return uniform_boxes(kInMotion, static_cast<std::uint64_t>(frame) + 10); });
  EXPECT_GT(share, 0.9);
}

TEST_F(FatBoxTrialTest, TellsThatNobodyLeavesThemWhereNobodyMovesAnyMore) {
  const double share = share_while([&](int) { return courses_.boxes(); });
  EXPECT_EQ(share, 0);
}

TEST_F(FatBoxTrialTest, IsOfNoUseWhereABodyHasGone) {
  trial_.begin(to(courses_.boxes()));
  EXPECT_TRUE(trial_.go_on(crew_, to(courses_.boxes())));
  EXPECT_FALSE(trial_.go_on(crew_, to(std::vector<Aabb>(kInMotion, kNobody))));
}

}  // namespace
}  // namespace cellsweep::stream
