#include <cmath>
#include <string>

#include "base/tuning.h"
#include "bench/tuning/rows.h"
#include "engines/stream/kernels/kernel.h"
#include "engines/stream/search/sweep.h"
#include "world/random.h"

namespace cellsweep::bench {
namespace {

using stream::Keys;
using stream::Sweep;

constexpr int kTimes = 20;
/// The world by which the limits of a sweep are judged.
constexpr std::size_t kBodies = 1024;

const stream::Kernels& kernels() {
  return *stream::find_kernels(VectorIsa::best);
}

double cell_seconds(std::span<const Aabb> boxes) {
  Cells cells;
  return quickest_seconds_of(kTimes, [&] { cells.build_seconds(boxes); });
}

/// 0 where the sweep gives up.
double sweep_seconds(std::span<const Aabb> boxes) {
  Sweep sweep;
  Keys found;
  bool done = true;
  const double seconds = quickest_seconds_of(kTimes, [&] {
    found.clear();
    done = sweep.find(kernels(), boxes, found);
  });
  return done ? seconds : 0;
}

/// Nanoseconds of a body by either way.
Measured sweep_and_cells(std::span<const Aabb> boxes) {
  const double to_ns = 1e9 / static_cast<double>(boxes.size());
  return {{"sweep", sweep_seconds(boxes) * to_ns}, {"cells", cell_seconds(boxes) * to_ns}};
}

Measured in_world_of(std::size_t bodies) {
  return sweep_and_cells(uniform(bodies, 0)->boxes());
}

/// So many cubes, so large that a sweep compares each with so many vectors of others.
Measured in_crowd_of(std::size_t bodies, double vectors) {
  const double edges = static_cast<double>(bodies) / (4 * kernels().lanes * vectors);  // of the world
  Random random(1);
  std::vector<Aabb> boxes(bodies);
  for (Aabb& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = static_cast<float>(random.between(0, edges));
      box.max[axis] = box.min[axis] + 1;
    }
  }
  return sweep_and_cells(boxes);
}

Measured in_crowd(double vectors) {
  return in_crowd_of(kBodies, vectors);
}

Measured in_large_crowd(double vectors) {
  return in_crowd_of(8 * kBodies, vectors);
}

/// Scene `uniform`, with so many bodies outside of where the others are that each costs so many tests: in
/// bytes those outside are all the same.
Measured with_some_outside(double tests) {
  const auto source = uniform(kBodies, 0);
  std::vector<Aabb> boxes(source->boxes().begin(), source->boxes().end());
  const auto outside = static_cast<std::size_t>(std::sqrt(2 * tests * kBodies));
  for (std::size_t i = 0; i < outside; ++i) {
    Aabb& box = boxes[i * kBodies / outside];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = static_cast<float>(1000 + 10 * i);
      box.max[axis] = box.min[axis] + 1;
    }
  }
  return sweep_and_cells(boxes);
}

/// Cubes on one axis, each of which overlaps about one other.
Measured on_a_line() {
  Random random(1);
  std::vector<Aabb> boxes(kBodies);
  for (Aabb& box : boxes) {
    const auto x = static_cast<float>(random.between(0, 2.0 * kBodies));
    box = {{x, 0, 0}, {x + 1, 1, 1}};
  }
  return sweep_and_cells(boxes);
}

void register_shares(const std::string& name, double limit, Measured (*measure)(double)) {
  for (const double share : {0.25, 0.5, 0.9}) {
    const double value = std::floor(share * limit);
    register_tuning_row(name + "/" + std::to_string(std::lround(value)), [=] { return measure(value); });
  }
}

}  // namespace

// Machines without vectors of bytes do not sweep. Beyond the last two limits nobody does.
void register_sweep_rows() {
  if (kernels().sweep == nullptr) return;
  for (std::size_t bodies = tuning::kMostSwept / 4; bodies <= 4 * tuning::kMostSwept; bodies *= 2)
    register_tuning_row("kMostSwept/" + std::to_string(bodies), [bodies] { return in_world_of(bodies); });
  register_tuning_row("kPlacesOfEdge/axis", on_a_line);
  register_tuning_row("kPlacesOfEdge/uniform", [] { return in_world_of(kBodies); });
  for (const double vectors : {0.5, 1.0, 2.0})
    register_tuning_row("kVectorsExpected/" + std::to_string(vectors).substr(0, 3),
                        [=] { return in_large_crowd(vectors); });
  register_shares("kVectorsOfSwept", tuning::kVectorsOfSwept, in_crowd);
  register_shares("kTestsOfSwept", tuning::kTestsOfSwept, with_some_outside);
}

}  // namespace cellsweep::bench
