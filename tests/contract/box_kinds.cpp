#include "contract/box_kinds.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/text.h"

namespace cellsweep::contract {
namespace {

constexpr float kDenormal = std::numeric_limits<float>::denorm_min();

/// A box from six numbers of `value()`, put in order on each axis.
template <class Value>
Aabb box_of(Value value) {
  Aabb box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float one = value();
    const float other = value();
    box.min[axis] = std::min(one, other);
    box.max[axis] = std::max(one, other);
  }
  return box;
}

Aabb cube_at(const std::array<float, 3>& low, float edge) {
  return {low, {low[0] + edge, low[1] + edge, low[2] + edge}};
}

/// From 1e-3 to 1e3, about log-uniform: a power of two times a fraction, so that no logarithm is needed.
float any_edge(Random& random) {
  const float fraction = 1.0F + random.unit();
  return std::clamp(std::ldexp(fraction, random.whole(-10, 9)), 1e-3F, 1e3F);
}

/// Unit cubes in a space that grows with their number: about two overlaps each.
Aabb uniform(Random& random, std::size_t, std::size_t count) {
  float side = 1;
  while (side * side * side < 4.0F * static_cast<float>(count)) side += 0.5F;
  return cube_at({random.between(0, side), random.between(0, side), random.between(0, side)}, 1);
}

Aabb very_different_sizes(Random& random, std::size_t, std::size_t) {
  Aabb box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = random.between(-500, 500);
    box.max[axis] = box.min[axis] + any_edge(random);
  }
  return box;
}

Aabb identical(Random&, std::size_t, std::size_t) {
  return {{1, 2, 3}, {4, 5, 6}};
}

/// Small whole numbers: most neighbours touch, on faces, edges or corners, and ties are everywhere.
Aabb touching(Random& random, std::size_t, std::size_t) {
  Aabb box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = static_cast<float>(random.whole(0, 6));
    box.max[axis] = box.min[axis] + static_cast<float>(random.whole(0, 2));
  }
  return box;
}

/// A lattice of unit cubes in which each touches its neighbours and no two share more.
Aabb touching_lattice(Random&, std::size_t index, std::size_t) {
  const auto coordinate = [](std::size_t i) { return static_cast<float>(i % 5); };
  return cube_at({coordinate(index), coordinate(index / 5), coordinate(index / 25)}, 1);
}

/// One inside the other inside the other; some at equal depth.
Aabb nested(Random& random, std::size_t, std::size_t count) {
  const float reach = 1.0F + static_cast<float>(random.below(2 * count + 1));
  return {{-reach, -reach, -reach}, {reach, reach, reach}};
}

/// Intervals inside one another on an axis of its own, apart or crossing on the others.
Aabb nested_on_one_axis(Random& random, std::size_t index, std::size_t count) {
  Aabb box = uniform(random, index, count);
  const float reach = 1.0F + static_cast<float>(random.below(count + 1));
  box.min[index % 3] = -reach;
  box.max[index % 3] = reach;
  return box;
}

Aabb one_giant(Random& random, std::size_t index, std::size_t count) {
  if (index == 0) return {{-1000, -1000, -1000}, {1000, 1000, 1000}};
  return uniform(random, index, count);
}

/// Zero thick, all in the plane z = 1.
Aabb one_plane(Random& random, std::size_t, std::size_t) {
  const float x = random.between(0, 10);
  const float y = random.between(0, 10);
  return {{x, y, 1}, {x + random.unit() * 2, y + random.unit() * 2, 1}};
}

/// Without extent, on few places, so that many share one.
Aabb points(Random& random, std::size_t, std::size_t) {
  const auto coordinate = [&] { return static_cast<float>(random.whole(0, 2)); };
  return cube_at({coordinate(), coordinate(), coordinate()}, 0);
}

/// Together on two axes, so that the third alone decides.
Aabb columns(Random& random, std::size_t, std::size_t count) {
  const float x = random.between(0, static_cast<float>(count) + 1);
  return {{x, 0, 0}, {x + random.between(0, 3), 1, 1}};
}

/// Ends next to each other in the float format: apart, touching and crossing differ in the last bit.
Aabb last_bits(Random& random, std::size_t, std::size_t) {
  return box_of([&] { return 1.0F + static_cast<float>(random.whole(0, 7)) * FLT_EPSILON; });
}

Aabb around_zero(Random& random, std::size_t, std::size_t) {
  static const std::vector<float> values = {
      -0.0F,       0.0F, kDenormal, -kDenormal, FLT_MIN, -FLT_MIN, FLT_MIN - kDenormal, kDenormal - FLT_MIN,
      2 * FLT_MIN, 1.0F, -1.0F};
  return box_of([&] { return random.pick(values); });
}

Aabb extreme_values(Random& random, std::size_t, std::size_t) {
  static const float below_max = std::nextafter(FLT_MAX, 0.0F);
  static const std::vector<float> values = {-FLT_MAX, -below_max, -1.0F, 0.0F, 1.0F, below_max, FLT_MAX};
  return box_of([&] { return random.pick(values); });
}

constexpr std::array kKinds = {
    BoxKind{"uniform", uniform},
    BoxKind{"very_different_sizes", very_different_sizes},
    BoxKind{"identical", identical},
    BoxKind{"touching", touching},
    BoxKind{"touching_lattice", touching_lattice},
    BoxKind{"nested", nested},
    BoxKind{"nested_on_one_axis", nested_on_one_axis},
    BoxKind{"one_giant", one_giant},
    BoxKind{"one_plane", one_plane},
    BoxKind{"points", points},
    BoxKind{"columns", columns},
    BoxKind{"last_bits", last_bits},
    BoxKind{"around_zero", around_zero, false},
    BoxKind{"extreme_values", extreme_values, false},
};

/// `box` moved along one axis; unchanged where that would leave the range of finite floats.
Aabb shifted(Aabb box, std::size_t axis, float by) {
  const float low = box.min[axis] + by;
  const float high = box.max[axis] + by;
  if (!std::isfinite(low) || !std::isfinite(high)) return box;
  box.min[axis] = low;
  box.max[axis] = high;
  return box;
}

/// `box` with its lower end on the upper end of `other`: they touch on that axis.
Aabb against_face(Aabb box, std::size_t axis, const Aabb& other) {
  const float thickness = box.max[axis] - box.min[axis];
  box.min[axis] = other.max[axis];
  box.max[axis] = other.max[axis] + thickness;
  if (!std::isfinite(box.max[axis])) box.max[axis] = FLT_MAX;
  return box;
}

Aabb grown_around(Aabb box, const Aabb& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = std::min(box.min[axis], other.min[axis]);
    box.max[axis] = std::max(box.max[axis], other.max[axis]);
  }
  return box;
}

float canonical_value(float value) {
  return std::isnormal(value) ? value : 0.0F;
}

}  // namespace

std::span<const BoxKind> box_kinds() {
  return kKinds;
}

const BoxKind& box_kind(std::string_view name) {
  const auto found = std::ranges::find(kKinds, name, &BoxKind::name);
  if (found == kKinds.end()) throw std::invalid_argument("no kind of boxes is called " + std::string(name));
  return *found;
}

std::vector<Aabb> make_boxes(const BoxKind& kind, Random& random, std::size_t count) {
  std::vector<Aabb> boxes;
  for (std::size_t index = 0; index < count; ++index) boxes.push_back(kind.make(random, index, count));
  return boxes;
}

Aabb next_box(const BoxKind& kind, Random& random, const Aabb& box, const Aabb& other) {
  const std::size_t axis = random.below(3);
  switch (random.below(8)) {
    case 0:
      return box;
    case 1:
      return other;
    case 2:
      return grown_around(box, other);
    case 3:
      return against_face(box, axis, other);
    case 4:
      return shifted(box, axis, random.between(-0.1F, 0.1F));
    case 5:
      return shifted(box, axis, static_cast<float>(random.whole(-2, 2)));
    default:
      return kind.make(random, 1 + random.below(64), 64);
  }
}

Aabb canonical_box(const Aabb& box) {
  Aabb result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.min[axis] = canonical_value(box.min[axis]);
    result.max[axis] = canonical_value(box.max[axis]);
  }
  return result;
}

std::string box_text(const Aabb& box) {
  const auto interval = [&](std::size_t axis) { return text("[", box.min[axis], ", ", box.max[axis], "]"); };
  return text(interval(0), " x ", interval(1), " x ", interval(2));
}

std::ostream& operator<<(std::ostream& out, const BoxKind& kind) {
  return out << kind.name;
}

}  // namespace cellsweep::contract
