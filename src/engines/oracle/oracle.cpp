#include "engines/oracle/oracle.h"

#include <algorithm>

#include "cellsweep/engine/phase_timer.h"
#include "engines/oracle/brute_force.h"

namespace cellsweep {

Capacity Oracle::capacity() const {
  return {kSlotMask, "", "a slot's number has 29 bits"};
}

// A slot without a body has a box that overlaps nothing.
Result<FoundPairs> Oracle::update(const BodyChanges& changes, Statistics& statistics) {
  PhaseTimer timer(statistics.phases);
  if (changes.none()) {
    timer.lap("all against all");
    return FoundPairs{};
  }
  pairs_.clear();
  for (const Pair& pair : brute_force_pairs(changes.boxes)) pairs_.push_back({pair.a, pair.b});
  timer.lap("all against all");
  statistics.bytes += pairs_.capacity() * sizeof(SlotPair);
  return FoundPairs{.began = pairs_, .is_whole_set = true};
}

Result<Broadphase> make_broadphase(const OracleOptions& options) {
  const auto make = []() -> Result<std::unique_ptr<Engine>> {
    return std::unique_ptr<Engine>(std::make_unique<Oracle>());
  };
  return EngineAccess::make("oracle", make, options.trace, "oracle");
}

}  // namespace cellsweep
