#include "engines/stream/sweep/number_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>

#include "base/tuning.h"
#include "cellsweep/pair.h"
#include "engines/stream/cells/box_sample.h"

namespace cellsweep::stream {
namespace {

constexpr std::uint32_t kFewestPlaces = 256;
constexpr std::uint32_t kBytes = 256;  // numbers on the other axes

/// Where numbers begin on an axis, and the length over which they are spread.
struct Spread {
  double origin;
  double length;
};

Spread ends_of(const AxisRange& range) {
  return {range.origin, range.length};
}

/// A few boxes lie beyond what the sample knows of; on the axis of the order they would share two places.
/// Where none of the sample lies far out, it has room for them; else they are few, or the sample would have
/// more.
Spread with_those_beyond(const AxisRange& range) {
  constexpr double kFarOut = 3;
  const double beyond = range.length / 8;
  const bool far_out = range.high - range.low > kFarOut * range.length;
  const double low = far_out ? range.origin : range.low;
  const double high = far_out ? range.origin + range.length : range.high;
  return {low - beyond, high - low + 2 * beyond};
}

/// The axis by which boxes are put in order: the one on which they are shortest by its length.
struct Order {
  unsigned axis = 0;
  Spread spread{};
  double edge = 1;  // of a box
};

/// A box is to reach over some places, or most of those who share one with it would not meet it.
Order choose_order(const BoxSample& sample) {
  const std::array<double, 3> edges = {sample.extents.x, sample.extents.y, sample.extents.z};
  Order order;
  double longest = -1;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double length = sample.axes[axis].length;
    const double edge = edges[axis] + 1e-4 * length + DBL_MIN;
    if (length <= longest * edge) continue;
    longest = length / edge;
    order = {axis, with_those_beyond(sample.axes[axis]), edge};
  }
  return order;
}

std::uint32_t places_for(const Order& order) {
  const double edges = order.spread.length / order.edge;
  const double wanted =
      std::clamp<double>(tuning::kPlacesOfEdge * edges, kFewestPlaces, NumberMap::kMostPlaces);
  return std::bit_ceil(static_cast<std::uint32_t>(wanted));
}

}  // namespace

void NumberMap::learn(std::span<const Aabb> boxes) {
  const BoxSample sample = take_rough_sample({boxes.data(), boxes.size()});
  const Order order = choose_order(sample);
  axis_ = order.axis;
  places_ = places_for(order);
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double count = axis == axis_ ? places_ : kBytes;
    const auto [origin, length] = axis == axis_ ? order.spread : ends_of(sample.axes[axis]);
    numbers_.origin[axis] = static_cast<float>(std::max(origin, double{-FLT_MAX}));
    numbers_.scale[axis] = length > 0 ? static_cast<float>(std::min(count / length, double{FLT_MAX})) : 0;
    numbers_.top[axis] = static_cast<float>(count - 1);
  }
  uses_ = 1;
  slots_known_ = boxes.size();
}

bool NumberMap::is_good_for(const Kernels& kernels, std::span<const Aabb> boxes) {
  if (uses_ == 0 || uses_ >= tuning::kSweepsOfSample || boxes.size() != slots_known_) return false;
  ++uses_;
  return most_are_inside(kernels, boxes);
}

// A box has as many of those looked at behind it as meet it. They are of places of chance: those at equal
// distances may have something in common.
double NumberMap::comparisons(const Kernels& kernels, std::span<const Aabb> boxes) const {
  constexpr std::size_t kLookedAt = 64, kEight = 8;
  std::array<std::uint32_t, kLookedAt> low, high;  // NOLINT(*-member-init): as far as they are read
  std::size_t count = 0;
  for (std::size_t first = 0; first < kLookedAt; first += kEight) {
    std::array<Aabb, kEight> eight;
    for (std::size_t i = 0; i < kEight; ++i) {
      const std::size_t from = (first + i) * boxes.size() / kLookedAt;
      const std::size_t to = (first + i + 1) * boxes.size() / kLookedAt;
      eight[i] = boxes[from + mix64(first + i) % (to - from)];
    }
    EightRows rows;
    kernels.eight_rows(eight.data(), numbers_, axis_, rows);
    for (std::size_t i = 0; i < kEight; ++i) {
      low[count] = rows.on_axis[i] & 0xffffU;
      high[count] = rows.on_axis[i] >> 16;
      count += rows.there >> i & 1;
    }
  }
  std::size_t met = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) met += (low[i] <= high[j] ? 1U : 0U) & (low[j] <= high[i] ? 1U : 0U);
  }
  const double pairs = static_cast<double>(count * (count - 1)) / 2;
  return count < 2 ? 0 : static_cast<double>(met) / pairs * static_cast<double>(boxes.size()) / 2;
}

// Most must not lie at the ends of an axis.
bool NumberMap::most_are_inside(const Kernels& kernels, std::span<const Aabb> boxes) const {
  constexpr std::size_t kLookedAt = 32, kEight = 8;
  const std::size_t step = boxes.size() / kLookedAt + 1;
  const auto are_beyond = [&](unsigned axis, std::uint32_t low, std::uint32_t high) {
    const bool is_cut = numbers_.scale[axis] > 0;
    const std::uint32_t top = axis == axis_ ? places_ - 1 : kBytes - 1;
    return is_cut && (low == top || high == 0);
  };
  std::size_t beyond = 0;
  for (std::size_t slot = 0; slot < boxes.size();) {
    std::array<Aabb, kEight> eight;
    for (Aabb& box : eight) {
      box = slot < boxes.size() ? boxes[slot] : kNobody;
      slot += step;
    }
    EightRows rows;
    kernels.eight_rows(eight.data(), numbers_, axis_, rows);
    for (unsigned i = 0; i < kEight; ++i) {
      const std::uint32_t on_axis = rows.on_axis[i], on_others = rows.on_others[i];
      const bool is_beyond = are_beyond(axis_, on_axis & 0xffffU, on_axis >> 16) ||
                             are_beyond((axis_ + 1) % 3, on_others & 0xffU, on_others >> 8 & 0xffU) ||
                             are_beyond((axis_ + 2) % 3, on_others >> 16 & 0xffU, on_others >> 24);
      beyond += is_beyond && (rows.there >> i & 1) != 0 ? 1 : 0;
    }
  }
  return beyond < kLookedAt / 4;
}

}  // namespace cellsweep::stream
