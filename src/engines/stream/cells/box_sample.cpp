#include "engines/stream/cells/box_sample.h"

#include <algorithm>
#include <cfloat>

#include "base/tuning.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {
namespace {

using tuning::kLargeEdges;
using tuning::kSample;

using Edges = std::array<double, 3>;

/// Some of the boxes, evenly spread over the list; slots without a body are left out.
struct Drawn {
  std::array<std::array<float, kSample>, 3> minima;
  std::array<std::array<float, kSample>, 3> edges;
  std::size_t count = 0;
};

void draw(const Boxes& boxes, Drawn& drawn) {
  const std::size_t wanted = std::min(boxes.count(), std::min(kSample, 24 + boxes.count() / 64));
  for (std::size_t i = 0; i < wanted; ++i) {
    const Aabb& box = boxes[i * boxes.count() / wanted];
    if (!(box.min[0] <= box.max[0])) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      drawn.minima[axis][drawn.count] = box.min[axis];
      drawn.edges[axis][drawn.count] = std::min(box.max[axis] - box.min[axis], FLT_MAX);
    }
    ++drawn.count;
  }
}

/// Twice the range of the middle half, not beyond the range of all. What lies outside falls into the cells at
/// the border, which are cut again when they are crowded.
AxisRange measure_axis(float* minima, std::size_t count) {
  std::sort(minima, minima + count);
  const double low = minima[0];
  const double high = minima[count - 1];
  const double quarter = minima[count / 4];
  const double middle_half = minima[count - 1 - count / 4] - quarter;
  if (!(middle_half > 0)) return {low, high - low};
  const double origin = std::max(low, quarter - middle_half / 2);
  return {origin, std::min(high, quarter + 1.5 * middle_half) - origin};
}

Edges clipped(Edges edges, const std::array<AxisRange, 3>& axes) {
  for (std::size_t axis = 0; axis < 3; ++axis) edges[axis] = std::min(edges[axis], axes[axis].length);
  return edges;
}

/// The edges beyond which a box is large.
Float4 large_edges(const Drawn& drawn) {
  Float4 limits{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<float, kSample> edges = drawn.edges[axis];
    const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(drawn.count / 2);
    std::nth_element(edges.begin(), middle, edges.begin() + static_cast<std::ptrdiff_t>(drawn.count));
    limits[axis] = std::min(*middle * kLargeEdges, FLT_MAX);
  }
  return limits;
}

/// How many are large, and the sums of their extents.
std::size_t add_large(const Boxes& boxes, Float4 limits, const std::array<AxisRange, 3>& axes,
                      Extents& sums) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < boxes.count(); ++i) {
    const BoxLanes box(boxes[i]);
    if (!on_any_axis((box.max - box.min) > limits)) continue;
    Edges edges;
    for (std::size_t axis = 0; axis < 3; ++axis) edges[axis] = double{box.max[axis]} - double{box.min[axis]};
    sums.add(clipped(edges, axes));
    ++count;
  }
  return count;
}

/// Means over the drawn ones that are not large.
Extents mean_of_usual(const Drawn& drawn, Float4 limits, const std::array<AxisRange, 3>& axes) {
  Extents sums;
  double count = 0;
  for (std::size_t i = 0; i < drawn.count; ++i) {
    bool usual = true;
    Edges edges;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      usual = usual && drawn.edges[axis][i] <= limits[axis];
      edges[axis] = drawn.edges[axis][i];
    }
    if (!usual) continue;
    sums.add(clipped(edges, axes));
    ++count;
  }
  Extents means;
  if (count > 0) means.add(sums, 1 / count);
  return means;
}

}  // namespace

void Extents::add(const std::array<double, 3>& edges) {
  const auto [i, j, k] = edges;
  add(Extents{i, j, k, i * j, j * k, k * i, i * j * k}, 1);
}

void Extents::add(const Extents& other, double weight) {
  x += weight * other.x, y += weight * other.y, z += weight * other.z;
  xy += weight * other.xy, yz += weight * other.yz, zx += weight * other.zx;
  xyz += weight * other.xyz;
}

double Extents::copies(const std::array<double, 3>& density) const {
  const auto [i, j, k] = density;
  return 1 + x * i + y * j + z * k + xy * i * j + yz * j * k + zx * k * i + xyz * i * j * k;
}

BoxSample take_sample(const Boxes& boxes) {
  Drawn drawn;
  draw(boxes, drawn);
  BoxSample sample;
  if (drawn.count == 0) return sample;
  for (std::size_t axis = 0; axis < 3; ++axis)
    sample.axes[axis] = measure_axis(drawn.minima[axis].data(), drawn.count);
  const Float4 limits = large_edges(drawn);
  Extents large;
  const auto count = static_cast<double>(boxes.count());
  const auto larges = static_cast<double>(add_large(boxes, limits, sample.axes, large));
  sample.extents.add(mean_of_usual(drawn, limits, sample.axes), 1 - larges / count);
  sample.extents.add(large, 1 / count);
  return sample;
}

}  // namespace cellsweep::stream
