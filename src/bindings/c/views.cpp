#include "bindings/c/views.h"

#include <type_traits>

#include "base/text.h"
#include "one_shot/box_set.h"

namespace cellsweep::c {
namespace {

template <class Number, std::size_t kAxes>
BoxView view_as(const cellsweep_boxes& boxes) {
  CoordinateArrays<Number, kAxes> arrays;
  arrays.count = boxes.count;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    arrays.min[axis] = {static_cast<const Number*>(boxes.min[axis].first), boxes.min[axis].stride};
    arrays.max[axis] = {static_cast<const Number*>(boxes.max[axis].first), boxes.max[axis].stride};
  }
  return arrays;
}

}  // namespace

static_assert(sizeof(cellsweep_aabb) == sizeof(Aabb));
static_assert(sizeof(cellsweep_pair) == sizeof(Pair));
static_assert(offsetof(cellsweep_pair, b) == offsetof(Pair, b));
static_assert(offsetof(cellsweep_filter, mask) == offsetof(BodyFilter, mask));
static_assert(offsetof(cellsweep_filter, is_static) == offsetof(BodyFilter, is_static));

Result<BoxView> view_of(const cellsweep_boxes& boxes) {
  if (boxes.axes != 2 && boxes.axes != 3) {
    return Status::bad_input(text("Boxes have 2 or 3 axes, not ", boxes.axes, "."), "axes", boxes.axes);
  }
  switch (boxes.number) {
    case CELLSWEEP_FLOAT:
      return boxes.axes == 2 ? view_as<float, 2>(boxes) : view_as<float, 3>(boxes);
    case CELLSWEEP_DOUBLE:
      return boxes.axes == 2 ? view_as<double, 2>(boxes) : view_as<double, 3>(boxes);
  }
  return Status::bad_input(text("There is no kind ", boxes.number, " of numbers."), "number");
}

Status Bodies::read(const cellsweep_ids& from) {
  return ids.read(from.first, from.stride, from.count, "ids");
}

Status Bodies::read(const cellsweep_filters& from) {
  return filters.read(from.first, from.stride, from.count, "filters");
}

Status Bodies::read(const cellsweep_boxes& from) {
  const Result<BoxView> view = view_of(from);
  if (!view) return view.status();
  if (Status status = one_shot::check_sets({&*view, 1}); !status.ok()) return status;
  boxes = bindings::boxes_of_world(*view, own_boxes);
  return {};
}

}  // namespace cellsweep::c
