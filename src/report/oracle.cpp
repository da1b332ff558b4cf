#include "report/oracle.h"

#include <cassert>
#include <numeric>

#include "cellsweep/broadphase.h"

namespace cellsweep::report {

namespace {

std::vector<Pair> pairs_of(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  auto oracle = make_broadphase(OracleOptions{});
  [[maybe_unused]] const bool good = oracle.ok() && oracle->insert(ids, boxes).ok() && oracle->update().ok();
  assert(good);
  return {oracle->pairs().begin(), oracle->pairs().end()};
}

}  // namespace

std::vector<Pair> oracle_pairs(std::span<const Aabb> boxes) {
  std::vector<BodyId> ids(boxes.size());
  std::iota(ids.begin(), ids.end(), BodyId{0});
  return pairs_of(ids, boxes);
}

std::vector<Pair> oracle_pairs(std::span<const BodyId> bodies, std::span<const Aabb> boxes) {
  std::vector<Aabb> some;
  some.reserve(bodies.size());
  for (const BodyId id : bodies) some.push_back(boxes[id]);
  return pairs_of(bodies, some);
}

std::vector<Pair> oracle_pairs(const FrameSource& source) {
  return oracle_pairs(source.bodies(), source.boxes());
}

}  // namespace cellsweep::report
