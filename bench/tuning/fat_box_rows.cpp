#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "base/tuning.h"
#include "bench/tuning/rows.h"
#include "cellsweep/broadphase.h"
#include "world/random.h"

namespace cellsweep::bench {
namespace {

constexpr std::size_t kBodies = 10'000;
constexpr int kUpdates = 48;

/// Cubes of edge 1 that go to and fro between two places: so many steps there, as many back, each along a
/// diagonal and at a time of its own.
class ToAndFro {
 public:
  ToAndFro(unsigned steps, float step)
      : steps_(steps),
        source_(uniform(kBodies, 0)),
        boxes_(source_->boxes().begin(), source_->boxes().end()) {
    for (std::size_t i = 0; i < kBodies; ++i) {
      Random random(1, i);
      starts_[i] = static_cast<unsigned>(random.below(2 * std::uint64_t{steps}));
      for (float& way : ways_[i]) way = random.below(2) == 0 ? step : -step;
    }
  }

  const std::vector<Aabb>& boxes() const { return boxes_; }

  void advance() {
    ++frame_;
    for (std::size_t i = 0; i < kBodies; ++i) {
      const bool back = (frame_ + starts_[i]) % (2 * steps_) >= steps_;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float by = back ? -ways_[i][axis] : ways_[i][axis];
        boxes_[i].min[axis] += by;
        boxes_[i].max[axis] += by;
      }
    }
  }

 private:
  unsigned steps_;
  unsigned frame_ = 0;
  std::unique_ptr<FrameSource> source_;
  std::vector<Aabb> boxes_;
  std::vector<unsigned> starts_ = std::vector<unsigned>(kBodies);
  std::vector<std::array<float, 3>> ways_ = std::vector<std::array<float, 3>>(kBodies);
};

/// Of a body in an update: nanoseconds, and how many fat boxes it needs.
Measured update_cost(unsigned steps, float step) {
  ToAndFro bodies(steps, step);
  Broadphase engine = std::move(*make_broadphase(StreamOptions{.threads = 1}));
  std::vector<BodyId> ids(kBodies);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  if (!engine.insert(ids, bodies.boxes()).ok()) return {};
  double seconds = 0;
  std::uint64_t made = 0;
  for (int update = 0; update < 2 * kUpdates; ++update) {
    if (update == kUpdates) seconds = 0, made = engine.statistics().work.boxes_placed;
    seconds += seconds_of([&] {
      if (engine.move(ids, bodies.boxes()).ok()) engine.update().ok();
    });
    bodies.advance();
  }
  const double updates = double{kUpdates} * kBodies;
  return {{"ns", 1e9 * seconds / updates},
          {"fat_boxes", static_cast<double>(engine.statistics().work.boxes_placed - made) / updates}};
}

std::string percent(float share) {
  return std::to_string(std::lround(100 * share));
}

}  // namespace

// In small steps; and a step there and one back.
void register_fat_box_rows() {
  for (const unsigned steps :
       {1U, tuning::kEarly - 1, tuning::kEarly, tuning::kEarly + 1, 2 * tuning::kEarly})
    register_tuning_row("kEarly/" + std::to_string(steps), [steps] { return update_cost(steps, 0.01F); });
  for (const float by : {0.25F, 0.9F, 1.1F, 2.0F}) {
    const float step = by * tuning::kMostTremble;
    register_tuning_row("kMostTremble/" + percent(step) + "%", [step] { return update_cost(1, step); });
  }
}

}  // namespace cellsweep::bench
