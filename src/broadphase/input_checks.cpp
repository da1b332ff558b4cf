#include "broadphase/input_checks.h"

#include <algorithm>
#include <vector>

#include "base/text.h"

namespace cellsweep {
namespace {

std::string describe_fault(const Aabb& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float low = box.min[axis];
    const float high = box.max[axis];
    const char name = "xyz"[axis];
    if (!std::isfinite(low) || !std::isfinite(high)) {
      return text("its ", name, " interval [", low, ", ", high, "] is not finite");
    }
    if (low > high) return text("its minimum on ", name, ", ", low, ", is above its maximum, ", high);
  }
  return {};
}

}  // namespace

Status invalid_box_status(BodyId body, const Aabb& box) {
  return {StatusCode::invalid_box,
          text("The box of body ", body, " is refused: ", describe_fault(box), "."),
          body,
          0,
          0,
          ""};
}

Status length_status(std::size_t ids, std::size_t boxes) {
  return {StatusCode::bad_input,
          text("There are ", ids, " ids but ", boxes, " boxes; one box an id is needed."),
          std::nullopt,
          0,
          0,
          ""};
}

std::optional<BodyId> find_duplicate(std::span<const BodyId> ids) {
  // Most callers list bodies in ascending order; then one pass is enough.
  const auto not_ascending = [](BodyId one, BodyId next) { return one >= next; };
  if (std::adjacent_find(ids.begin(), ids.end(), not_ascending) == ids.end()) return std::nullopt;
  std::vector<BodyId> sorted(ids.begin(), ids.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice == sorted.end()) return std::nullopt;
  return *twice;
}

Status unknown_body_status(BodyId body) {
  return {StatusCode::unknown_body, text("Body ", body, " is not in the engine."), body, 0, 0, ""};
}

Status duplicate_body_status(BodyId body, const char* where) {
  return {StatusCode::duplicate_body, text("Body ", body, " is ", where, "."), body, 0, 0, ""};
}

}  // namespace cellsweep
