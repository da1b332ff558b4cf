#include "engines/stream/cells/grid.h"

namespace cellsweep::stream {

Grid::Grid(const double (&origin)[3], const double (&scale)[3], const std::uint32_t (&dims)[3])
    : row_(dims[0]), plane_(dims[0] * dims[1]), cells_(dims[0] * dims[1] * dims[2]) {
  for (int axis = 0; axis < 3; ++axis) {
    origin_min_[axis] = origin_max_[axis + 1] = static_cast<float>(origin[axis]);
    scale_min_[axis] = scale_max_[axis + 1] = static_cast<float>(scale[axis]);
    top_min_[axis] = top_max_[axis + 1] = static_cast<float>(dims[axis] - 1);
  }
}

GridNumbers Grid::numbers() const {
  GridNumbers numbers{{}, {}, {}, row_, plane_};
  for (int axis = 0; axis < 3; ++axis) {
    numbers.origin[axis] = origin_min_[axis];
    numbers.scale[axis] = scale_min_[axis];
    numbers.top[axis] = top_min_[axis];
  }
  return numbers;
}

}  // namespace cellsweep::stream
