#include "queries/checks.h"

#include <cfloat>

#include "base/text.h"

namespace cellsweep::queries {
namespace {

using Place = std::optional<std::size_t>;

[[gnu::cold]] std::string in_batch(Place place) {
  return place ? text(" of question ", *place) : std::string();
}

[[gnu::cold]] Status refuse_box(const Aabb& box, Place place) {
  std::string fault;
  for (std::size_t axis = 0; axis < 3 && fault.empty(); ++axis) {
    const float min = box.min[axis];
    const float max = box.max[axis];
    if (min >= -FLT_MAX && min <= max && max <= FLT_MAX) continue;
    fault = text("on axis ", "xyz"[axis], " it goes from ", min, " to ", max);
  }
  Status status = Status::bad_input(text("The box", in_batch(place), " is refused: ", fault,
                                         "; both must be finite, the first not above the other."));
  status.code = StatusCode::invalid_box;
  return status;
}

[[gnu::cold]] Status refuse_direction(const std::array<double, 3>& d, Place place) {
  return Status::bad_input(
      text("The direction", in_batch(place), " is (", d[0], ", ", d[1], ", ", d[2],
           "); a component must differ from 0, and each be within the range of a float."));
}

[[gnu::cold]] Status refuse_number(const char* what, double number, Place place) {
  return Status::bad_input(
      text(what, in_batch(place), " is ", number, "; it must be 0 or more, or infinity."));
}

}  // namespace

Status check(const Aabb& box, Place place) {
  if (!is_good(box)) return refuse_box(box, place);
  return {};
}

Status check(const Region& region, Place place) {
  if (!is_good(region.box)) return refuse_box(region.box, place);
  if (!(region.distance >= 0)) return refuse_number("The distance", region.distance, place);
  return {};
}

Status check(const Path& path, Place place) {
  if (!is_good(path.box)) return refuse_box(path.box, place);
  if (!is_direction(path.direction)) return refuse_direction(path.direction, place);
  if (!(path.end >= 0)) return refuse_number("The end", path.end, place);
  return {};
}

Status check_most(double most) {
  if (!(most >= 0)) return refuse_number("The largest distance", most, {});
  return {};
}

Status check_room(std::size_t questions, std::size_t room) {
  if (questions == room) return {};
  return Status::bad_input(
      text("There are ", questions, " questions and room for ", room, " answers; give one to each."), {},
      room, questions);
}

}  // namespace cellsweep::queries
