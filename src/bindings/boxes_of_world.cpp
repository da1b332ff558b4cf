#include "bindings/boxes_of_world.h"

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "base/float_environment.h"

namespace cellsweep::bindings {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// The largest float that is not above a number; of those next to 0, -FLT_MIN or 0.
float at_most(double number) {
  const auto near = static_cast<float>(number);
  if (std::fabs(number) < FLT_MIN) return number < 0 ? -FLT_MIN : 0;
  return near > number ? std::nextafter(near, -kInfinity) : near;
}

/// The smallest float that is not below it; of those next to 0, 0 or FLT_MIN.
float at_least(double number) {
  return -at_most(-number);
}

void set_axis(Aabb& box, std::size_t axis, float min, float max) {
  box.min[axis] = min;
  box.max[axis] = max;
}

// To the inside where the minimum is above the maximum, so that it still is.
void set_axis(Aabb& box, std::size_t axis, double min, double max) {
  const bool is_inverted = min > max;
  box.min[axis] = is_inverted ? at_least(min) : at_most(min);
  box.max[axis] = is_inverted ? at_most(max) : at_least(max);
}

template <class Number>
Number read(const BoxView::Face& face, std::size_t index) {
  Number number;
  std::memcpy(&number, face.first + static_cast<std::ptrdiff_t>(index) * face.stride, sizeof number);
  return number;
}

template <class Number>
void gather(const BoxView& view, std::span<Aabb> boxes) {
  for (std::size_t axis = 0; axis < view.axes(); ++axis) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      set_axis(boxes[i], axis, read<Number>(view.face(axis), i), read<Number>(view.face(axis + 3), i));
    }
  }
  if (view.axes() == 3) return;
  for (Aabb& box : boxes) set_axis(box, 2, 0.0F, 0.0F);
}

bool is_array_of_boxes(const BoxView& view) {
  if (view.is_double() || view.axes() != 3) return false;
  const std::byte* first = view.face(0).first;
  if (reinterpret_cast<std::uintptr_t>(first) % alignof(Aabb) != 0) return false;
  for (std::size_t face = 0; face < 6; ++face) {
    if (view.face(face).first != first + face * sizeof(float)) return false;
    if (view.face(face).stride != sizeof(Aabb)) return false;
  }
  return true;
}

}  // namespace

std::span<const Aabb> boxes_of_world(const BoxView& view, std::vector<Aabb>& own) {
  if (view.size() == 0) return {};
  if (is_array_of_boxes(view)) {
    return {reinterpret_cast<const Aabb*>(view.face(0).first), view.size()};
  }
  const DefaultFloats floats;
  own.resize(view.size());
  if (view.is_double()) {
    gather<double>(view, own);
  } else {
    gather<float>(view, own);
  }
  return own;
}

}  // namespace cellsweep::bindings
