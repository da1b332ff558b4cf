#include "broadphase/bodies/box_checks.h"

#include <algorithm>

#include "geometry/box_lanes.h"
#include "geometry/canonical.h"

namespace cellsweep {

bool are_clean(std::span<const Aabb> boxes) {
  Int4 clean = {-1, -1, -1, -1};
  for (const Aabb& box : boxes) clean &= clean_lanes(BoxLanes(box));
  return on_all_axes(clean);
}

bool are_valid(std::span<const Aabb> boxes) {
  return are_clean(boxes) ||
         std::all_of(boxes.begin(), boxes.end(), [](const Aabb& box) { return is_valid(canonical(box)); });
}

}  // namespace cellsweep
