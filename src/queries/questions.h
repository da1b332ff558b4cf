/// @file
/// One question at a time, after it was checked: what the calls of query.h and their batches share.
#pragma once

#include <optional>
#include <vector>

#include "cellsweep/query.h"
#include "queries/world.h"

namespace cellsweep::queries {

/// The world and whom a call asks for.
struct Asked {
  const World& world;
  const QueryFilter& filter;
};

/// Each appends its answers in the order that query.h states, but the visits.
void list_overlaps(const Asked& asked, const Region& region, std::vector<BodyId>& found);
void list_touches(const Asked& asked, const Path& path, std::vector<Touch>& found);
void list_within(const Asked& asked, const Region& region, std::vector<Neighbor>& found);

void visit_overlaps(const Asked& asked, const Region& region, FunctionRef<bool(BodyId)> visit);
void visit_touches(const Asked& asked, const Path& path, FunctionRef<double(const Touch&, double)> visit);

bool any_overlap(const Asked& asked, const Region& region);
bool any_touch(const Asked& asked, const Path& path);
std::optional<Touch> first_touch(const Asked& asked, const Path& path);

/// Overwrites `found`.
void list_nearest(const Asked& asked, const Aabb& box, std::size_t count, double most,
                  std::vector<Neighbor>& found);

}  // namespace cellsweep::queries
