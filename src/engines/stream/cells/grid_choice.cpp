#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "base/tuning.h"
#include "engines/stream/cells/box_sample.h"
#include "engines/stream/cells/grid.h"

namespace cellsweep::stream {
namespace {

using tuning::kCopyCost;
using tuning::kMaxCells;
using tuning::kPieceBoxes;
using tuning::kTestCost;

struct Plan {
  std::array<std::uint32_t, 3> dims = {1, 1, 1};
  double cost = DBL_MAX;  // for one box
  double copies = 1;      // of one box
};

/// The width of cells, in extents of a box, that gives so many cells; of axes that are longer than that.
double cell_width(std::array<double, 3> lengths, double cells) {
  for (const std::size_t axis : {0, 1, 0}) {  // the longest first
    if (lengths[axis] < lengths[axis + 1]) std::swap(lengths[axis], lengths[axis + 1]);
  }
  const double three = std::cbrt(lengths[0] * lengths[1] * lengths[2] / cells);
  if (lengths[2] > 0 && lengths[2] >= three) return three;
  const double two = std::sqrt(lengths[0] * lengths[1] / cells);
  if (lengths[1] > 0 && lengths[1] >= two) return two;
  return lengths[0] / cells;
}

/// As many cells as wanted, so that cells are about as long on each axis as boxes are there.
std::array<std::uint32_t, 3> divide(const BoxSample& sample, double cells) {
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

double density_on(const AxisRange& axis, std::uint32_t dim) {
  return axis.length > 0 ? dim / axis.length : 0;
}

Plan plan_for(const BoxSample& sample, double boxes, double boxes_in_cell) {
  Plan plan;
  plan.dims = divide(sample, std::max(1.0, boxes / boxes_in_cell));
  std::array<double, 3> density{};  // of borders between cells
  for (std::size_t axis = 0; axis < 3; ++axis)
    density[axis] = density_on(sample.axes[axis], plan.dims[axis] - 1);
  plan.copies = sample.extents.copies(density);
  const double cells = double{1.0} * plan.dims[0] * plan.dims[1] * plan.dims[2];
  plan.cost = plan.copies * (kCopyCost + kTestCost * boxes * plan.copies / cells);
  return plan;
}

Grid make_grid(const BoxSample& sample, const Plan& plan) {
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

std::size_t GridChoice::most_copies(std::size_t boxes) const {
  constexpr double kAnyNumber = 1e18;
  return static_cast<std::size_t>(std::min(copies * static_cast<double>(boxes), kAnyNumber));
}

GridChoice choose_grid(const Boxes& boxes, Look look, double most_copies) {
  const BoxSample sample = take_sample(boxes, look);
  const auto count = static_cast<double>(boxes.count());
  const double most_expected = look == Look::at_all_carefully ? most_copies / 8 : (1 + most_copies) / 2;
  Plan best;
  double best_in_cell = 0;
  for (double in_cell = 8; in_cell < count && in_cell < 600; in_cell *= 1.6) {
    const Plan plan = plan_for(sample, count, in_cell);
    if (plan.cost < best.cost && plan.copies <= most_expected) {
      best = plan;
      best_in_cell = in_cell;
    }
  }
  const bool pays = best.cost < 0.9 * kTestCost * count;
  if (pays && count / best_in_cell > kMaxCells) {
    best = plan_for(sample, count, std::max(kPieceBoxes, count / kMaxCells));
  }
  const bool cuts = best.dims[0] * best.dims[1] * best.dims[2] > 1;
  const double copies =
      look == Look::at_few ? std::min(tuning::kManyCopies * best.copies, most_copies) : most_copies;
  return {make_grid(sample, best), pays && cuts, copies};
}

}  // namespace cellsweep::stream
