#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "base/tuning.h"
#include "engines/stream/cells/grid.h"

namespace cellsweep::stream {
namespace {

using tuning::kCopyCost;
using tuning::kMaxCells;
using tuning::kPieceBoxes;
using tuning::kSample;
using tuning::kTestCost;

/// What a sample of the boxes tells about one axis.
struct Axis {
  double origin = 0;
  double length = 0;  // over which most minima lie
};

/// Means over the sample, of extents and of their products, which say how many cells a box reaches into.
struct Extents {
  double x = 0, y = 0, z = 0, xy = 0, yz = 0, zx = 0, xyz = 0;

  /// The expected number of cells of a box, for so many cells a unit of length on each axis.
  double copies(const std::array<double, 3>& density) const {
    const auto [i, j, k] = density;
    return 1 + x * i + y * j + z * k + xy * i * j + yz * j * k + zx * k * i + xyz * i * j * k;
  }
};

struct Sample {
  std::array<Axis, 3> axes;
  Extents extents;
};

/// Where most minima lie: twice the range of the middle half, not beyond the range of all. What lies outside
/// falls into the cells at the border, which are cut again when they are crowded.
Axis measure_axis(float* minima, std::size_t count) {
  std::sort(minima, minima + count);
  const double low = minima[0];
  const double high = minima[count - 1];
  const double quarter = minima[count / 4];
  const double middle_half = minima[count - 1 - count / 4] - quarter;
  if (!(middle_half > 0)) return {low, high - low};
  const double origin = std::max(low, quarter - middle_half / 2);
  return {origin, std::min(high, quarter + 1.5 * middle_half) - origin};
}

Sample take_sample(const Boxes& boxes) {
  std::array<std::array<float, kSample>, 3> minima;
  Sample sample;
  Extents& sum = sample.extents;
  std::size_t taken = 0;
  const std::size_t wanted = std::min(boxes.count(), std::min(kSample, 24 + boxes.count() / 64));
  for (std::size_t i = 0; i < wanted; ++i) {
    const Aabb& box = boxes[i * boxes.count() / wanted];
    if (!(box.min[0] <= box.max[0])) continue;
    std::array<double, 3> edge{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      minima[axis][taken] = box.min[axis];
      edge[axis] = double{box.max[axis]} - double{box.min[axis]};
    }
    ++taken;
    sum.x += edge[0], sum.y += edge[1], sum.z += edge[2];
    sum.xy += edge[0] * edge[1], sum.yz += edge[1] * edge[2], sum.zx += edge[2] * edge[0];
    sum.xyz += edge[0] * edge[1] * edge[2];
  }
  if (taken == 0) return sample;
  for (double* mean : {&sum.x, &sum.y, &sum.z, &sum.xy, &sum.yz, &sum.zx, &sum.xyz})
    *mean /= static_cast<double>(taken);
  for (std::size_t axis = 0; axis < 3; ++axis) sample.axes[axis] = measure_axis(minima[axis].data(), taken);
  return sample;
}

struct Plan {
  std::array<std::uint32_t, 3> dims = {1, 1, 1};
  double cost = DBL_MAX;  // for one box
};

/// The width of cells, in extents of a box, that gives so many cells; of axes that are longer than that.
double cell_width(std::array<double, 3> lengths, double cells) {
  std::sort(lengths.rbegin(), lengths.rend());
  const double three = std::cbrt(lengths[0] * lengths[1] * lengths[2] / cells);
  if (lengths[2] > 0 && lengths[2] >= three) return three;
  const double two = std::sqrt(lengths[0] * lengths[1] / cells);
  if (lengths[1] > 0 && lengths[1] >= two) return two;
  return lengths[0] / cells;
}

/// As many cells as wanted, so that cells are about as long on each axis as boxes are there.
std::array<std::uint32_t, 3> divide(const Sample& sample, double cells) {
  const std::array<double, 3> extent = {sample.extents.x, sample.extents.y, sample.extents.z};
  std::array<double, 3> lengths{};  // of the axes, in extents of a box
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double length = sample.axes[axis].length;
    lengths[axis] = length / (extent[axis] + 1e-4 * length + DBL_MIN);
  }
  const double width = cell_width(lengths, cells);
  std::array<std::uint32_t, 3> dims = {1, 1, 1};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (lengths[axis] <= width) continue;
    dims[axis] =
        static_cast<std::uint32_t>(std::min<double>(std::round(lengths[axis] / width), Grid::kMaxDim));
  }
  return dims;
}

double density_on(const Axis& axis, std::uint32_t dim) {
  return axis.length > 0 ? dim / axis.length : 0;
}

Plan plan_for(const Sample& sample, double boxes, double boxes_in_cell) {
  Plan plan;
  plan.dims = divide(sample, std::max(1.0, boxes / boxes_in_cell));
  std::array<double, 3> density{};
  for (std::size_t axis = 0; axis < 3; ++axis) density[axis] = density_on(sample.axes[axis], plan.dims[axis]);
  const double copies = sample.extents.copies(density);
  const double cells = double{1.0} * plan.dims[0] * plan.dims[1] * plan.dims[2];
  plan.cost = copies * (kCopyCost + kTestCost * boxes * copies / cells);
  return plan;
}

Grid make_grid(const Sample& sample, const Plan& plan) {
  double origin[3];
  double scale[3];
  std::uint32_t dims[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    origin[axis] = sample.axes[axis].origin;
    dims[axis] = plan.dims[axis];
    scale[axis] = dims[axis] == 1 ? 0 : std::min(density_on(sample.axes[axis], dims[axis]), double{FLT_MAX});
  }
  return {origin, scale, dims};
}

}  // namespace

GridChoice choose_grid(const Boxes& boxes) {
  const Sample sample = take_sample(boxes);
  const auto count = static_cast<double>(boxes.count());
  Plan best;
  double best_in_cell = 0;
  for (double in_cell = 8; in_cell < count && in_cell < 600; in_cell *= 1.6) {
    const Plan plan = plan_for(sample, count, in_cell);
    if (plan.cost < best.cost) {
      best = plan;
      best_in_cell = in_cell;
    }
  }
  const bool pays = best.cost < 0.9 * kTestCost * count;
  if (pays && count / best_in_cell > kMaxCells) {
    best = plan_for(sample, count, std::max(kPieceBoxes, count / kMaxCells));
  }
  const bool cuts = best.dims[0] * best.dims[1] * best.dims[2] > 1;
  return {make_grid(sample, best), pays && cuts};
}

}  // namespace cellsweep::stream
