#include "queries/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace cellsweep::queries {
namespace {

float plain(float value) {
  return std::fabs(value) < std::numeric_limits<float>::min() ? 0.0F : value;
}

Aabb plain(Aabb box) {
  for (float& value : box.min) value = plain(value);
  for (float& value : box.max) value = plain(value);
  return box;
}

double shifted(double time, double by) {
  return time + std::fabs(time) * by;
}

bool sooner(const Touch& one, const Touch& other) {
  return std::pair(one.time, one.body) < std::pair(other.time, other.body);
}

bool nearer(const Neighbor& one, const Neighbor& other) {
  return std::pair(one.distance, one.body) < std::pair(other.distance, other.body);
}

}  // namespace

double box_distance(const Aabb& one, const Aabb& other) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double gap = 0;
    if (one.min[axis] > other.max[axis])
      gap = static_cast<double>(one.min[axis]) - static_cast<double>(other.max[axis]);
    if (other.min[axis] > one.max[axis])
      gap = static_cast<double>(other.min[axis]) - static_cast<double>(one.max[axis]);
    sum += gap * gap;
  }
  return std::sqrt(sum);
}

// Both boxes canonical.
std::optional<double> touch_time(const Path& path, const Aabb& box) {
  constexpr double kSlack = 0x1p-51;
  double latest = 0;
  double enters = 0;
  double leaves = path.end;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double d = path.direction[axis];
    const double gap_before = static_cast<double>(box.min[axis]) - static_cast<double>(path.box.max[axis]);
    const double gap_behind = static_cast<double>(box.max[axis]) - static_cast<double>(path.box.min[axis]);
    if (d == 0) {
      if (gap_before > 0 || gap_behind < 0) return std::nullopt;
    } else {
      const double begin = (d > 0 ? gap_before : gap_behind) / d;
      const double end = (d > 0 ? gap_behind : gap_before) / d;
      latest = std::fmax(latest, begin);
      enters = std::fmax(enters, std::isinf(begin) ? begin : shifted(begin, -kSlack));
      leaves = std::fmin(leaves, std::isinf(end) ? end : shifted(end, kSlack));
    }
  }
  if (enters > leaves) return std::nullopt;
  return latest;
}

BodyFilter Reference::filter_of(BodyId body) const {
  const auto found = filters.find(body);
  return found == filters.end() ? BodyFilter{} : found->second;
}

bool Reference::is_answer(BodyId body, const QueryFilter& filter) const {
  if (filter.as && !may_pair(*filter.as, filter_of(body))) return false;
  return !filter.predicate || filter.predicate(body);
}

std::vector<BodyId> Reference::overlaps(const Region& region, const QueryFilter& filter) const {
  std::vector<BodyId> found;
  for (const auto& [body, box] : boxes) {
    if (box_distance(box, plain(region.box)) <= region.distance && is_answer(body, filter))
      found.push_back(body);
  }
  return found;
}

std::vector<Touch> Reference::touches(const Path& path, const QueryFilter& filter) const {
  Path asked = path;
  asked.box = plain(path.box);
  std::vector<Touch> found;
  for (const auto& [body, box] : boxes) {
    const auto time = touch_time(asked, box);
    if (time && is_answer(body, filter)) found.push_back({body, *time});
  }
  std::ranges::sort(found, sooner);
  return found;
}

std::vector<Neighbor> Reference::within(const Region& region, const QueryFilter& filter) const {
  std::vector<Neighbor> found;
  for (const BodyId body : overlaps(region, filter))
    found.push_back({body, box_distance(boxes.at(body), plain(region.box))});
  std::ranges::sort(found, nearer);
  return found;
}

std::vector<Neighbor> Reference::nearest(const Aabb& box, std::size_t count, double most,
                                         const QueryFilter& filter) const {
  std::vector<Neighbor> found = within(Region(box, most), filter);
  found.resize(std::min(found.size(), count));
  return found;
}

std::vector<Pair> Reference::pairs_of(const std::vector<BodyId>& bodies) const {
  std::set<Pair> found;
  for (const BodyId body : bodies) {
    for (const BodyId other : overlaps(boxes.at(body), {.as = filter_of(body), .predicate = {}})) {
      if (other != body) found.insert(make_pair_of(body, other));
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace cellsweep::queries
