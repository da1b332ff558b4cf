#include "ranks/cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cellsweep::ranks {
namespace {

std::vector<Region> all_to_first(int ranks) {
  std::vector<Region> regions(static_cast<std::size_t>(ranks), kNowhere);
  regions.front() = kEverywhere;
  return regions;
}

Region around(const Region& one, const Region& other) {
  Region both;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    both.above[axis] = std::min(one.above[axis], other.above[axis]);
    both.up_to[axis] = std::max(one.up_to[axis], other.up_to[axis]);
  }
  return both;
}

// Whether a path comes along a region, closed on all sides. Times are taken a little earlier and later than
// they are computed, more than a query does that decides about bodies.
bool may_reach(const Region& region, const Path& path) {
  constexpr double kSlack = 1e-12;
  double begin = 0;
  double end = path.end;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = double{region.above[axis]} - path.box.max[axis];
    const double high = double{region.up_to[axis]} - path.box.min[axis];
    const double speed = path.direction[axis];
    if (speed == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    const double first = std::min(low / speed, high / speed);
    const double last = std::max(low / speed, high / speed);
    begin = std::max(begin, first - kSlack * std::fabs(first));
    end = std::min(end, last + kSlack * std::fabs(last));
  }
  return begin <= end;
}

}  // namespace

Cuts::Cuts(int ranks) : Cuts(all_to_first(ranks)) {}

Cuts::Cuts(std::vector<Region> regions) : regions_(std::move(regions)) {
  std::size_t nodes = 1;
  while (nodes < regions_.size()) nodes *= 2;
  bounds_.resize(2 * nodes);
  bound(all());
}

const Region& Cuts::bound(const Range& range) {
  Region& here = bounds_[range.node];
  return here = range.is_leaf() ? regions_[range.first] : around(bound(range.lower()), bound(range.upper()));
}

template <class IsWanted, class Visit>
void Cuts::visit(const Range& range, const IsWanted& is_wanted, const Visit& visit_rank) const {
  if (!is_wanted(bounds_[range.node])) return;
  if (range.is_leaf()) return visit_rank(static_cast<int>(range.first));
  visit(range.lower(), is_wanted, visit_rank);
  visit(range.upper(), is_wanted, visit_rank);
}

void Cuts::find_reached(const Aabb& box, std::vector<int>& ranks) const {
  ranks.clear();
  visit(
      all(), [&](const Region& region) { return reaches(region, box); },
      [&](int rank) { ranks.push_back(rank); });
}

void Cuts::find_reached(const Path& path, std::vector<int>& ranks) const {
  ranks.clear();
  visit(
      all(), [&](const Region& region) { return may_reach(region, path); },
      [&](int rank) { ranks.push_back(rank); });
}

int Cuts::home_of(const Point& point) const {
  int home = 0;
  visit(
      all(), [&](const Region& region) { return holds(region, point); }, [&](int rank) { home = rank; });
  return home;
}

}  // namespace cellsweep::ranks
