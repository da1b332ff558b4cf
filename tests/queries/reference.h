/// @file
/// The answers to queries by looking at each body, written down from what query.h states and nothing else.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "cellsweep/query.h"

namespace cellsweep::queries {

/// Bodies with canonical boxes, and filters of those that have another than the default.
struct Reference {
  std::map<BodyId, Aabb> boxes;
  std::map<BodyId, BodyFilter> filters;

  std::vector<BodyId> overlaps(const Region& region, const QueryFilter& filter = {}) const;
  std::vector<Touch> touches(const Path& path, const QueryFilter& filter = {}) const;
  std::vector<Neighbor> within(const Region& region, const QueryFilter& filter = {}) const;
  std::vector<Neighbor> nearest(const Aabb& box, std::size_t count, double most,
                                const QueryFilter& filter = {}) const;
  std::vector<Pair> pairs_of(const std::vector<BodyId>& bodies) const;

 private:
  BodyFilter filter_of(BodyId body) const;
  bool is_answer(BodyId body, const QueryFilter& filter) const;
};

/// When a path touches a box first, if it does.
std::optional<double> touch_time(const Path& path, const Aabb& box);

/// How far two boxes are from each other.
double box_distance(const Aabb& one, const Aabb& other);

}  // namespace cellsweep::queries
