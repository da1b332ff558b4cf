#include "report/picture/cuts.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/text.h"
#include "cellsweep/query.h"

namespace cellsweep::report {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A side that has no end is null.
Point side_of(const nlohmann::json& side, float end) {
  Point point{};
  if (side.size() != point.size()) throw std::invalid_argument("a corner of a region has not three numbers");
  for (std::size_t axis = 0; axis < point.size(); ++axis)
    point[axis] = side[axis].is_null() ? end : side[axis].get<float>();
  return point;
}

Aabb region_of(const nlohmann::json& rank) {
  const nlohmann::json& region = rank.at("region");
  return {side_of(region.at(0), -kInfinity), side_of(region.at(1), kInfinity)};
}

// Open below and closed above, so that each point is in one.
bool holds(const Aabb& region, const Point& point) {
  bool holds = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    holds = holds && point[axis] > region.min[axis] && point[axis] <= region.max[axis];
  return holds;
}

// Of no size where nothing of it is in the world.
Aabb clipped(const Aabb& region, const Aabb& world) {
  Aabb part = region;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    part.min[axis] = std::max(region.min[axis], world.min[axis]);
    part.max[axis] = std::min(region.max[axis], world.max[axis]);
    if (part.min[axis] >= part.max[axis]) return {};
  }
  return part;
}

}  // namespace

Result<std::vector<Aabb>> read_cuts(const std::string& words) {
  std::vector<Aabb> regions;
  try {
    const nlohmann::json run = nlohmann::json::parse(words);
    for (const nlohmann::json& rank : run.at("ranks")) regions.push_back(region_of(rank));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return Status::bad_input(text("It is not what cellsweep-ranks --json prints: ", error.what(), "."));
  }
  if (regions.empty())
    return Status::bad_input("It is not what cellsweep-ranks --json prints: it has no rank.");
  return regions;
}

void show_cuts(const std::vector<Aabb>& regions, const std::vector<Aabb>& boxes, Tableau& tableau) {
  for (const Aabb& region : regions) {
    const Aabb part = clipped(region, tableau.world);
    if (part.min != part.max) tableau.frames.push_back(part);
  }
  for (const Aabb& box : boxes) {
    const auto found =
        std::ranges::find_if(regions, [&](const Aabb& region) { return holds(region, box.min); });
    tableau.groups.push_back(static_cast<std::uint32_t>(found - regions.begin()));
  }
}

}  // namespace cellsweep::report
