#include "queries/questions.h"

#include <algorithm>
#include <span>
#include <vector>

#include "queries/regions/reach.h"
#include "queries/regions/reach_walk.h"
#include "queries/regions/region_walk.h"
#include "queries/short_sort.h"

namespace cellsweep::queries {
namespace {

using Slots = std::span<const Slot>;

/// Whether all that a walk through a region's box finds are answers. Else their boxes are looked at, which by
/// slot lie anywhere in memory.
bool are_all_answers(const Asked& asked, const Reach& reach) {
  return reach.distance() == 0 && asked.world.overlaps_are_certain() && !asked.filter.as &&
         !asked.filter.predicate;
}

/// Calls `visit(slot)` for the answers until it returns false.
template <class Visit>
void for_each_overlap(const Asked& asked, const Reach& reach, const Visit& visit) {
  const bool overlap_for_certain = reach.distance() > 0 || asked.world.overlaps_are_certain();
  const auto take = [&](Slots slots) {
    for (const Slot slot : slots) {
      if (!overlap_for_certain && !overlap(reach.box(), asked.world.box(slot))) continue;
      if (asked.world.is_answer(asked.filter, slot) && !visit(slot)) return false;
    }
    return true;
  };
  if (reach.distance() > 0) return visit_near(asked.world, reach, take);
  walk_region(asked.world, reach.around(), take);
}

}  // namespace

void visit_overlaps(const Asked& asked, const Region& region, FunctionRef<bool(BodyId)> visit) {
  for_each_overlap(asked, Reach(region), [&](Slot slot) { return visit(asked.world.id(slot)); });
}

void list_overlaps(const Asked& asked, const Region& region, std::vector<BodyId>& found) {
  const std::size_t before = found.size();
  const Reach reach(region);
  // Ids at once: where memory runs out later on, the caller has no slots in their place.
  const auto list_all = [&](Slots slots) {
    const std::size_t here = found.size();
    found.resize(here + slots.size());
    std::ranges::transform(slots, &found[here], [&](Slot slot) { return asked.world.id(slot); });
    return true;
  };
  const auto list = [&](Slot slot) {
    found.push_back(asked.world.id(slot));
    return true;
  };
  if (are_all_answers(asked, reach)) {
    walk_region(asked.world, reach.around(), list_all);
  } else if (reach.distance() == 0) {
    for_each_overlap(asked, reach, list);
  } else {
    list_near(asked.world, reach, [&](Slots slots) {
      for (const Slot slot : slots) {
        if (asked.world.is_answer(asked.filter, slot)) list(slot);
      }
    });
  }
  sort_ids(asked.world.kernels(), std::span(found).subspan(before));
}

bool any_overlap(const Asked& asked, const Region& region) {
  bool any = false;
  for_each_overlap(asked, Reach(region), [&](Slot) {
    any = true;
    return false;
  });
  return any;
}

void list_within(const Asked& asked, const Region& region, std::vector<Neighbor>& found) {
  const std::size_t before = found.size();
  const Reach reach(region);
  measure_near(asked.world, reach, [&](Slots slots, const double* distances) {
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (asked.world.is_answer(asked.filter, slots[i]))
        found.push_back({asked.world.id(slots[i]), distances[i]});
    }
  });
  sort_neighbors(std::span(found).subspan(before));
}

}  // namespace cellsweep::queries
