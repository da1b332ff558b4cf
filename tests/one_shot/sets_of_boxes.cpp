#include "one_shot/sets_of_boxes.h"

#include <cfloat>
#include <limits>

#include "contract/random.h"

namespace cellsweep::one_shot {
namespace {

using contract::Random;
using Boxes = std::vector<Box<double, 3>>;

double unit(Random& random) {
  return static_cast<double>(random.bits() >> 11) * 0x1p-53;
}

/// Edges of up to `edge` around places that `place(axis)` names.
template <class Place>
Boxes make(std::size_t count, std::uint64_t seed, double edge, const Place& place) {
  Random random(seed);
  Boxes boxes(count);
  for (auto& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = place(random, axis);
      box.max[axis] = box.min[axis] + edge * unit(random);
    }
  }
  return boxes;
}

Boxes uniform(std::size_t count, std::uint64_t seed) {
  return make(count, seed, 0.2, [](Random& random, std::size_t) { return unit(random); });
}

Boxes far_from_zero(std::size_t count, std::uint64_t seed) {
  return make(count, seed, 0.2, [](Random& random, std::size_t) { return 1e12 + unit(random); });
}

/// Neighbours touch or miss each other by the last bit.
Boxes last_bits(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Boxes boxes(count);
  for (auto& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int step = random.whole(0, 3);
      box.min[axis] = (1 + step) * (1 + random.whole(0, 2) * DBL_EPSILON);
      box.max[axis] = (2 + step) * (1 + random.whole(0, 2) * DBL_EPSILON);
    }
  }
  return boxes;
}

Boxes points(std::size_t count, std::uint64_t seed) {
  return make(count, seed, 0, [](Random& random, std::size_t) { return random.whole(0, 9) * 0.1; });
}

Boxes identical(std::size_t count, std::uint64_t) {
  return Boxes(count, {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}});
}

Boxes nested(std::size_t count, std::uint64_t) {
  Boxes boxes(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double half = 1 + static_cast<double>(i) * 1e-9;
    boxes[i] = {{-half, -half, -half}, {half, half, half}};
  }
  return boxes;
}

Boxes rods(std::size_t count, std::uint64_t seed) {
  Boxes boxes = make(count, seed, 0.01, [](Random& random, std::size_t) { return unit(random); });
  for (std::size_t i = 0; i < count; ++i) boxes[i].min[i % 3] = -1e6, boxes[i].max[i % 3] = 1e6;
  return boxes;
}

/// All magnitudes that there are, denormals included, of both signs.
Boxes all_magnitudes(std::size_t count, std::uint64_t seed) {
  constexpr double kValues[] = {-DBL_MAX,
                                -1e200,
                                -1e39,
                                -1,
                                -1e-40,
                                -1e-300,
                                -std::numeric_limits<double>::denorm_min(),
                                -0.0,
                                0.0,
                                std::numeric_limits<double>::denorm_min(),
                                1e-300,
                                1e-40,
                                1,
                                1e39,
                                1e200,
                                DBL_MAX};
  Random random(seed);
  Boxes boxes(count);
  for (auto& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int low = random.whole(0, 15);
      box.min[axis] = kValues[low];
      box.max[axis] = kValues[random.whole(low, 15)];
    }
  }
  return boxes;
}

}  // namespace

std::vector<Box<double, 3>> two_tiny_clusters(std::size_t count, std::uint64_t seed) {
  Boxes boxes = make(count, seed, 1e-4, [](Random& random, std::size_t) { return unit(random) * 1e-3; });
  // A step of doubles there is 0.0001, and the floats' nearly 100,000.
  for (std::size_t i = 0; i < count; i += 2) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      boxes[i].min[axis] = 1e12 + boxes[i].min[axis] * 1e3;
      boxes[i].max[axis] = 1e12 + boxes[i].max[axis] * 1e3;
    }
  }
  return boxes;
}

const std::vector<DoubleKind>& double_kinds() {
  static const std::vector<DoubleKind> kinds = {
      {"uniform", uniform}, {"far from zero", far_from_zero},   {"last bits", last_bits},
      {"points", points},   {"identical", identical},           {"nested", nested},
      {"rods", rods},       {"all magnitudes", all_magnitudes}, {"two tiny clusters", two_tiny_clusters},
  };
  return kinds;
}

}  // namespace cellsweep::one_shot
