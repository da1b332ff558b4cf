#include "report/oracle.h"

#include <cassert>
#include <numeric>

#include "cellsweep/broadphase.h"

namespace cellsweep::report {

std::vector<Pair> oracle_pairs(std::span<const Aabb> boxes) {
  std::vector<BodyId> ids(boxes.size());
  std::iota(ids.begin(), ids.end(), BodyId{0});
  auto oracle = make_broadphase(OracleOptions{});
  [[maybe_unused]] const bool good = oracle.ok() && oracle->insert(ids, boxes).ok() && oracle->update().ok();
  assert(good);
  return {oracle->pairs().begin(), oracle->pairs().end()};
}

}  // namespace cellsweep::report
