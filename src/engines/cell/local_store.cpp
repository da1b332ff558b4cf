#include "cellsweep/local_store.h"

#include <numeric>

namespace cellsweep {

std::uint64_t LocalStoreMap::used() const {
  return std::accumulate(parts.begin(), parts.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const LocalStorePart& part) { return sum + part.bytes; });
}

}  // namespace cellsweep
