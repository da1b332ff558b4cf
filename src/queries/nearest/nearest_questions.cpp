#include <vector>

#include "geometry/canonical.h"
#include "queries/nearest/nearest_walk.h"
#include "queries/questions.h"

namespace cellsweep::queries {

void list_nearest(const Asked& asked, const Aabb& box, std::size_t count, double most,
                  std::vector<Neighbor>& found) {
  NearestList nearest(count, most, found);
  walk_nearest(asked.world, canonical(box), asked.filter, nearest);
  nearest.sort();
}

}  // namespace cellsweep::queries
