/// @file
/// Engine `oracle`: all boxes against all boxes, whatever changed.
#pragma once

#include <vector>

#include "cellsweep/engine/engine.h"

namespace cellsweep {

/// Remembers nothing from one update to the next.
class Oracle final : public Engine {
 public:
  Capacity capacity() const override;
  Result<FoundPairs> update(const BodyChanges& changes, Statistics& statistics) override;

 private:
  std::vector<SlotPair> pairs_;
};

}  // namespace cellsweep
