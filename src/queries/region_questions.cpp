#include "queries/questions.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "geometry/canonical.h"
#include "queries/nearest_walk.h"
#include "queries/outward.h"
#include "queries/region_box.h"
#include "queries/region_walk.h"
#include "queries/short_sort.h"

namespace cellsweep::queries {
namespace {

using Slots = std::span<const Slot>;

/// A region, canonical.
class Reach {
 public:
  explicit Reach(const Region& region) : box_(region.box), around_(box_), distance_(region.distance) {
    if (distance_ != 0) around_ = RegionBox(box_around(box_.box(), distance_));
  }

  /// A box around the region.
  const RegionBox& around() const { return around_; }
  double distance() const { return distance_; }
  /// How far it is to each of some boxes; behind the last distance there is room for kDistancesAtOnce.
  void measure(const World& world, Slots slots, double* distances) const {
    world.kernels().distances(world.boxes().data(), slots.data(), static_cast<std::uint32_t>(slots.size()),
                              box_.box(), distances);
  }

 private:
  static Aabb box_around(const Aabb& box, double distance) {
    // A distance that is computed may be less than the true one by a few roundings of it.
    const double most = distance * (1 + 0x1p-50);
    Aabb around;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      around.min[axis] = below(box.min[axis] - most);
      around.max[axis] = above(box.max[axis] + most);
    }
    return around;
  }

  RegionBox box_;
  RegionBox around_;
  double distance_;
};

/// Whether all that a walk through a region's box finds are answers. Else their boxes are looked at, which by
/// slot lie anywhere in memory.
bool are_all_answers(const Asked& asked, const Reach& reach) {
  return reach.distance() == 0 && asked.world.overlaps_are_certain() && !asked.filter.as &&
         !asked.filter.predicate;
}

/// Those of some bodies that are near enough. Distances are computed side by side, several in little more
/// time than one.
class NearBodies {
 public:
  NearBodies(const World& world, const Reach& reach) : world_(world), reach_(reach) {}

  /// Of these, at most kRowBoxes. Returns how many there are.
  std::size_t find(Slots slots) {
    reach_.measure(world_, slots, distances_.data());
    // Half of them are too far, nobody could foretell which: all are written down, and most written over.
    std::size_t near = 0;
    for (std::size_t i = 0; i < slots.size(); ++i) {
      slots_[near] = slots[i];
      distances_[near] = distances_[i];
      near += distances_[i] <= reach_.distance() ? 1 : 0;
    }
    return near;
  }
  /// Of those that were found last.
  Slot slot(std::size_t i) const { return slots_[i]; }
  double distance(std::size_t i) const { return distances_[i]; }

 private:
  const World& world_;
  const Reach& reach_;
  std::array<Slot, kRowBoxes> slots_;                           // NOLINT(*-member-init): as far as it is read
  std::array<double, kRowBoxes + kDistancesAtOnce> distances_;  // NOLINT(*-member-init): as far as it is read
};

/// Calls `visit(slot)` for the answers until it returns false.
template <class Visit>
void for_each_near(const Asked& asked, const Reach& reach, const Visit& visit) {
  NearBodies near(asked.world, reach);
  walk_region(asked.world, reach.around(), [&](Slots slots) {
    const std::size_t count = near.find(slots);
    for (std::size_t i = 0; i < count; ++i) {
      if (asked.world.is_answer(asked.filter, near.slot(i)) && !visit(near.slot(i))) return false;
    }
    return true;
  });
}

/// The same, whatever the region.
template <class Visit>
void for_each_overlap(const Asked& asked, const Reach& reach, const Visit& visit) {
  if (reach.distance() > 0) return for_each_near(asked, reach, visit);
  const bool overlap_for_certain = asked.world.overlaps_are_certain();
  walk_region(asked.world, reach.around(), [&](Slots slots) {
    for (const Slot slot : slots) {
      if (!overlap_for_certain && !overlap(reach.around().box(), asked.world.box(slot))) continue;
      if (asked.world.is_answer(asked.filter, slot) && !visit(slot)) return false;
    }
    return true;
  });
}

/// Calls `take(slot, distance)` for those of some bodies that are near enough. A walk finds few at a time:
/// they wait for others.
template <class Take>
class WithinReach {
 public:
  WithinReach(const Asked& asked, const Reach& reach, const Take& take)
      : asked_(asked), near_(asked.world, reach), take_(take) {}

  /// At most kRowBoxes.
  void add(Slots slots) {
    if (count_ + slots.size() > kRowBoxes) finish();
    std::ranges::copy(slots, waiting_.begin() + static_cast<std::ptrdiff_t>(count_));
    count_ += slots.size();
  }

  void finish() {
    const std::size_t count = near_.find(std::span(waiting_).first(count_));
    for (std::size_t i = 0; i < count; ++i) {
      if (asked_.world.is_answer(asked_.filter, near_.slot(i))) take_(near_.slot(i), near_.distance(i));
    }
    count_ = 0;
  }

 private:
  const Asked& asked_;
  NearBodies near_;
  const Take& take_;
  std::size_t count_ = 0;
  std::array<Slot, kRowBoxes> waiting_;  // NOLINT(*-member-init): as far as it is read
};

template <class Take>
void for_each_within(const Asked& asked, const Reach& reach, const Take& take) {
  WithinReach within(asked, reach, take);
  walk_region(asked.world, reach.around(), [&](Slots slots) {
    within.add(slots);
    return true;
  });
  within.finish();
}

}  // namespace

void visit_overlaps(const Asked& asked, const Region& region, FunctionRef<bool(BodyId)> visit) {
  for_each_overlap(asked, Reach(region), [&](Slot slot) { return visit(asked.world.id(slot)); });
}

void list_overlaps(const Asked& asked, const Region& region, std::vector<BodyId>& found) {
  const std::size_t before = found.size();
  const Reach reach(region);
  if (are_all_answers(asked, reach)) {
    walk_region(asked.world, reach.around(), [&](Slots slots) {
      // Ids at once: where memory runs out later on, the caller has no slots in their place.
      const std::size_t here = found.size();
      found.resize(here + slots.size());
      std::ranges::transform(slots, &found[here], [&](Slot slot) { return asked.world.id(slot); });
      return true;
    });
  } else if (reach.distance() == 0) {
    for_each_overlap(asked, reach, [&](Slot slot) {
      found.push_back(asked.world.id(slot));
      return true;
    });
  } else {
    for_each_within(asked, reach, [&](Slot slot, double) { found.push_back(asked.world.id(slot)); });
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
  for_each_within(asked, reach, [&](Slot slot, double distance) {
    found.push_back({asked.world.id(slot), distance});
  });
  sort_neighbors(std::span(found).subspan(before));
}

void list_nearest(const Asked& asked, const Aabb& box, std::size_t count, double most,
                  std::vector<Neighbor>& found) {
  NearestList nearest(count, most, found);
  walk_nearest(asked.world, canonical(box), asked.filter, nearest);
  nearest.sort();
}

}  // namespace cellsweep::queries
