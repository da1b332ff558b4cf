/// @file
/// Engine `embree`: the tree of a ray tracer against itself (rtcCollide), for comparison.
#pragma once

#include <cstdint>

#include "cellsweep/embree.h"
#include "cellsweep/engine/engine.h"
#include "engines/embree/collider.h"

namespace cellsweep::embree {

/// Builds a tree over all boxes when anything changed, and finds all pairs.
class EmbreeEngine final : public Engine {
 public:
  explicit EmbreeEngine(unsigned threads) : collider_(threads) {}

  Capacity capacity() const override;
  Result<FoundPairs> update(const BodyChanges& changes, Statistics& statistics) override;

 private:
  Collider collider_;
  std::uint64_t builds_ = 0;
};

}  // namespace cellsweep::embree
