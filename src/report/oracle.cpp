#include "report/oracle.h"

#include <cassert>
#include <numeric>

#include "cellsweep/broadphase.h"

namespace cellsweep::report {

namespace {

std::vector<Pair> pairs_of(std::span<const BodyId> ids, std::span<const Aabb> boxes,
                           std::span<const BodyFilter> filters) {
  auto oracle = make_broadphase(OracleOptions{});
  [[maybe_unused]] const bool good =
      oracle.ok() && oracle->insert(ids, boxes, filters).ok() && oracle->update().ok();
  assert(good);
  return {oracle->pairs().begin(), oracle->pairs().end()};
}

}  // namespace

std::vector<Pair> oracle_pairs(std::span<const Aabb> boxes) {
  std::vector<BodyId> ids(boxes.size());
  std::iota(ids.begin(), ids.end(), BodyId{0});
  return pairs_of(ids, boxes, {});
}

std::vector<Pair> oracle_pairs(std::span<const BodyId> bodies, std::span<const Aabb> boxes,
                               std::span<const BodyFilter> filters) {
  std::vector<Aabb> some;
  std::vector<BodyFilter> some_filters;
  some.reserve(bodies.size());
  for (const BodyId id : bodies) {
    some.push_back(boxes[id]);
    if (!filters.empty()) some_filters.push_back(filters[id]);
  }
  return pairs_of(bodies, some, some_filters);
}

std::vector<Pair> oracle_pairs(const FrameSource& source) {
  return oracle_pairs(source.bodies(), source.boxes(), source.filters());
}

}  // namespace cellsweep::report
