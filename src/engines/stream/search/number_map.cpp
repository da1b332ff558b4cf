#include "engines/stream/search/number_map.h"

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

// Calls `see(on_axis, on_others)` for so many boxes, a multiple of eight, or for all if there are no more.
// They are of places of chance: those at equal distances may have something in common.
template <std::size_t kCount, class See>
void NumberMap::look_at(const Kernels& kernels, std::span<const Aabb> boxes, const See& see) const {
  constexpr std::size_t kEight = 8;
  for (std::size_t first = 0; first < kCount; first += kEight) {
    std::array<Aabb, kEight> eight;
    for (std::size_t i = first; i < first + kEight; ++i) {
      const std::size_t from = i * boxes.size() / kCount;
      const std::size_t to = (i + 1) * boxes.size() / kCount;
      eight[i - first] = from < to ? boxes[from + mix64(i) % (to - from)] : kNobody;
    }
    EightRows rows;
    kernels.eight_rows(eight.data(), numbers_, axis_, rows);
    for (std::size_t i = 0; i < kEight; ++i) {
      if ((rows.there >> i & 1) != 0) see(rows.on_axis[i], rows.on_others[i]);
    }
  }
}

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

// Most must not lie at the ends of an axis.
bool NumberMap::most_are_inside(const Kernels& kernels, std::span<const Aabb> boxes) const {
  constexpr std::size_t kLookedAt = 32;
  const auto is_beyond = [&](unsigned axis, std::uint32_t low, std::uint32_t high) {
    const std::uint32_t top = axis == axis_ ? places_ - 1 : kBytes - 1;
    return numbers_.scale[axis] > 0 && (low == top || high == 0);
  };
  std::size_t beyond = 0;
  look_at<kLookedAt>(kernels, boxes, [&](std::uint32_t on_axis, std::uint32_t on_others) {
    const bool on_any = is_beyond(axis_, on_axis & 0xffffU, on_axis >> 16) ||
                        is_beyond((axis_ + 1) % 3, on_others & 0xffU, on_others >> 8 & 0xffU) ||
                        is_beyond((axis_ + 2) % 3, on_others >> 16 & 0xffU, on_others >> 24);
    beyond += on_any ? 1 : 0;
  });
  return beyond < kLookedAt / 4;
}

// A box has as many of those looked at behind it as meet it.
double NumberMap::comparisons(const Kernels& kernels, std::span<const Aabb> boxes) const {
  constexpr std::size_t kLookedAt = 64;
  std::array<std::uint32_t, kLookedAt> low, high;  // NOLINT(*-member-init): as far as they are read
  std::size_t count = 0;
  std::size_t met = 0;
  look_at<kLookedAt>(kernels, boxes, [&](std::uint32_t on_axis, std::uint32_t) {
    low[count] = on_axis & 0xffffU;
    high[count] = on_axis >> 16;
    for (std::size_t i = 0; i < count; ++i)
      met += (low[i] <= high[count] ? 1U : 0U) & (low[count] <= high[i] ? 1U : 0U);
    ++count;
  });
  if (count < 2) return 0;
  const double pairs = static_cast<double>(count * (count - 1)) / 2;
  return static_cast<double>(met) / pairs * static_cast<double>(boxes.size()) / 2;
}

}  // namespace cellsweep::stream
