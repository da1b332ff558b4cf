/// @file
/// The caller's rounding, denormals and traps: they change no answer, whichever call they come with, and are
/// as they were when a call returns.
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "cellsweep/query.h"
#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random.h"
#include "contract/random_caller.h"
#include "float_settings.h"

namespace cellsweep::contract {
namespace {

#if defined(__SSE2__) || defined(__aarch64__)

/// 1 + 2^-30, -1 - 2^-30 and the double of 2^-140.
struct Sums {
  volatile float above = 1;
  volatile float below = -1;
  volatile float tiny = 0x1p-140F;

  void compute() {
    const volatile float little = 0x1p-30F;
    above = above + little;
    below = below - little;
    tiny = tiny + tiny;
  }
};

// An emulator that did not would make the tests below say nothing.
TEST(FloatEnvironment, OfThisProcessorDoesWhatItsSettingsSay) {
#if defined(__SSE2__)
  constexpr unsigned kUp = 0x5f80, kDown = 0x3f80, kFlush = 0x9f80;
#else
  constexpr std::uint64_t kUp = 1U << 22U, kDown = 2U << 22U, kFlush = 1U << 24U;
#endif
  const auto usual = float_settings();
  Sums as_usual, up, down, flushed;
  as_usual.compute();
  set_float_settings(kUp);
  up.compute();
  set_float_settings(kDown);
  down.compute();
  set_float_settings(kFlush);
  flushed.compute();
  set_float_settings(usual);
  EXPECT_EQ(as_usual.above, 1);
  EXPECT_EQ(as_usual.below, -1);
  EXPECT_EQ(as_usual.tiny, 0x1p-139F);
  EXPECT_GT(up.above, 1);
  EXPECT_EQ(up.below, -1);
  EXPECT_EQ(down.above, 1);
  EXPECT_LT(down.below, -1);
  EXPECT_EQ(flushed.tiny, 0);
}

#endif

/// The settings of the next call, and those that the thread has between calls.
class Environment {
 public:
  explicit Environment(std::uint64_t seed) : random_(seed) {}

  void operator()(bool before) {
    if (before) {
      set_float_settings(all_[random_.below(all_.size())]);
      of_call_ = float_settings();
      return;
    }
    const auto found = float_settings();
    set_float_settings(usual_);
    EXPECT_EQ(found, of_call_) << "the call left other settings than it found";
  }

 private:
  decltype(all_float_settings()) all_ = all_float_settings();
  decltype(float_settings()) usual_ = float_settings();
  decltype(float_settings()) of_call_ = usual_;
  Random random_;
};

using FloatEnvironmentContract = PerEngine;

TEST_P(FloatEnvironmentContract, IsTheCallersAndChangesNoAnswer) {
  for (const char* name : {"uniform", "last_bits", "around_zero", "extreme_values"}) {
    const BoxKind& kind = box_kind(name);
    for (std::uint64_t seed = 0; seed < repeated(4U, effort(4U, 1U, 1U)); ++seed) {
      CheckedEngine checked(GetParam(), story_of(kind, 40, seed) + ", floating-point settings of all kinds");
      checked.surround_calls(Environment(seed));
      RandomCaller caller(checked, kind, 40, seed);
      ASSERT_TRUE(caller.fill());
      for (int step = 0; step < effort(12, 3); ++step) ASSERT_TRUE(caller.step());
      ASSERT_EQ(checked.failures(), 0);
    }
  }
}

// A denormal number that is taken for 0 makes a bad box look good, and a good direction bad.
TEST_P(FloatEnvironmentContract, HidesNothingThatIsWrongWithAQuestion) {
  constexpr float kTiny = std::numeric_limits<float>::denorm_min();
  constexpr double kTinier = std::numeric_limits<double>::denorm_min();
  Broadphase broadphase = make(GetParam());
  ASSERT_TRUE(broadphase.insert(1, cube_at(0)).ok());
  ASSERT_TRUE(broadphase.update().ok());
  const Queries queries = broadphase.queries();
  const Region bad_box(Aabb{{kTiny, 0, 0}, {0, 1, 1}});
  const Region bad_distance(cube_at(0), -kTinier);
  const Path slow = Ray{{0.5F, 0.5F, 0.5F}, {kTinier, 0, 0}};
  Path ends_before = slow;
  ends_before.end = -kTinier;
  for (const auto now : all_float_settings()) {
    bool bad = false;
    bool good = false;
    BatchAnswers<BodyId> lists;
    std::vector<Neighbor> nearest;
    {
      const FloatSettings of_caller(now);
      bad = queries.any_overlap(bad_box).ok() || queries.any_overlap(bad_distance).ok() ||
            queries.any_touch(ends_before).ok() || queries.find_overlaps({&bad_box, 1}, lists).ok() ||
            queries.find_overlaps({&bad_distance, 1}, lists).ok() ||
            queries.find_nearest(cube_at(0), 1, nearest, -kTinier).ok();
      good = queries.any_touch(slow).ok() && queries.first_touch(slow).ok();
    }
    EXPECT_FALSE(bad) << "settings " << now;
    EXPECT_TRUE(good) << "settings " << now;
  }
}

/// What a broadphase says of distances and times, which are computed.
struct ComputedAnswers {
  std::vector<Neighbor> nearest;
  std::vector<Touch> touches;
  std::vector<BodyId> overlaps;

  bool ask(const Broadphase& broadphase, const Region& region, const Path& path) {
    const Queries queries = broadphase.queries();
    return queries.find_nearest(region.box, 12, nearest).ok() && queries.find_touches(path, touches).ok() &&
           queries.find_overlaps(region, overlaps).ok();
  }
  friend bool operator==(const ComputedAnswers&, const ComputedAnswers&) = default;
};

TEST_P(FloatEnvironmentContract, ChangesNoDistanceAndNoTime) {
  for (const char* name : {"uniform", "last_bits", "around_zero"}) {
    Broadphase broadphase = make(GetParam());
    Random random(3);
    const std::vector<Aabb> boxes = make_boxes(box_kind(name), random, 16);
    std::vector<BodyId> ids(boxes.size());
    std::iota(ids.begin(), ids.end(), BodyId{0});
    ASSERT_TRUE(broadphase.insert(ids, boxes).ok() && broadphase.update().ok());
    const Region region(boxes[7], 0.7);
    const Path path = Ray::between({-3, 0.1F, 0.2F}, boxes[11].max);
    ComputedAnswers usual;
    ASSERT_TRUE(usual.ask(broadphase, region, path));
    for (const auto now : all_float_settings()) {
      ComputedAnswers answers;
      bool all = false;
      {
        const FloatSettings of_caller(now);
        all = answers.ask(broadphase, region, path);
      }
      EXPECT_TRUE(all && answers == usual) << name << ", settings " << now;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, FloatEnvironmentContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
