/// @file
/// Whether a body is on its way or trembles, and how far its fat boxes reach.
#include "engines/stream/bodies/course.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

Aabb unit_box_at(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

/// A body of length 1 that moves along x.
class CourseOfOne {
 public:
  explicit CourseOfOne(const Growth& growth = {}) : growth_(growth) {}

  /// So many updates pass; then the body leaves its fat box by this step, or moves inside of it.
  void step(float by, std::uint32_t updates, bool left = true) {
    update_ += updates;
    const Aabb before = unit_box_at(x_);
    x_ += by;
    fat_ = course_.next_fat_box(fat_, before, unit_box_at(x_), left, {update_, 8, 0, growth_});
  }

  bool trembles() const { return course_.trembles(); }
  float behind() const { return x_ - fat_.min[0]; }
  float ahead() const { return fat_.max[0] - (x_ + 1); }

 private:
  static constexpr std::uint32_t kFirst = 1000;

  Growth growth_;
  std::uint32_t update_ = kFirst;
  Course course_ = Course::of_long_ago(kFirst);
  float x_ = 0;
  Aabb fat_ = unit_box_at(0);
};

constexpr float kSlowStep = 0.001F;
constexpr std::uint32_t kSoonAfter = 2;
constexpr std::uint32_t kLongAfter = 50;

TEST(BodyCourse, OfABodyOnItsWayLeadsAhead) {
  CourseOfOne mover;
  for (const std::uint32_t updates : {1U, 8U, kLongAfter, 100U}) {
    mover.step(0.05F, updates + tuning::kEarly);
    EXPECT_FALSE(mover.trembles()) << updates;
    EXPECT_NEAR(mover.ahead(), 8 * 0.05F, 1e-5F);
    EXPECT_NEAR(mover.behind(), 0, 1e-5F);
  }
}

TEST(BodyCourse, OfABodyThatTurnsSoonReachesToEitherSide) {
  CourseOfOne mover;
  mover.step(kSlowStep, kLongAfter);
  mover.step(-kSlowStep, kSoonAfter);
  EXPECT_TRUE(mover.trembles());
  EXPECT_GT(mover.ahead(), kSlowStep);
  EXPECT_GT(mover.behind(), kSlowStep);
}

TEST(BodyCourse, OfAFastBodyThatTurnsSoonDoesNotTremble) {
  CourseOfOne mover;
  mover.step(kSlowStep, kLongAfter);
  mover.step(-2 * tuning::kMostTremble, kSoonAfter);
  EXPECT_FALSE(mover.trembles());
}

TEST(BodyCourse, OfABodyThatStaysIsNotJudged) {
  CourseOfOne mover;
  mover.step(kSlowStep, kLongAfter);
  mover.step(-kSlowStep, kSoonAfter, false);
  EXPECT_FALSE(mover.trembles());
}

TEST(BodyCourse, ReachesFurtherUntilItLastsAndThenLessFar) {
  CourseOfOne mover;
  mover.step(kSlowStep, kLongAfter);
  mover.step(-kSlowStep, kSoonAfter);
  float reach = mover.behind();
  bool grew = false;
  for (int time = 0; time < 8; ++time) {
    mover.step(time % 2 == 0 ? kSlowStep : -kSlowStep, tuning::kEarlyOfTrembling);
    EXPECT_TRUE(mover.trembles());
    EXPECT_GE(mover.behind(), reach);
    EXPECT_LE(mover.behind(), 2 * tuning::kMostTremble);
    grew = grew || mover.behind() > reach;
    reach = mover.behind();
  }
  EXPECT_TRUE(grew);
  int times = 0;
  for (; mover.trembles() && times < 20; ++times)
    mover.step(times % 2 == 0 ? kSlowStep : -kSlowStep, kLongAfter);
  EXPECT_GT(times, 1) << "by halves";
  EXPECT_FALSE(mover.trembles());
}

TEST(BodyCourse, ReachesLessFarWhereGrowthIsTight) {
  const Growth tight = {.updates = tuning::kTightSteps,
                        .steps = tuning::kTightSteps,
                        .most_halvings = tuning::kTightHalvings,
                        .raise = tuning::kTightRaise};
  CourseOfOne usual;
  CourseOfOne close(tight);
  for (CourseOfOne* const mover : {&usual, &close}) {
    mover->step(kSlowStep, kLongAfter);
    mover->step(-kSlowStep, kSoonAfter);
    EXPECT_TRUE(mover->trembles());
  }
  EXPECT_LT(3 * close.behind(), usual.behind());
}

}  // namespace
}  // namespace cellsweep::stream
