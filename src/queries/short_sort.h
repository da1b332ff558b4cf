/// @file
/// Sorts the few answers that most questions have. Each is put where it belongs by counting those before it:
/// no branch depends on the numbers, which come in no order and would be foretold wrongly half of the time.
#pragma once

#include <span>

#include "cellsweep/query.h"
#include "queries/kernels/kernel.h"

namespace cellsweep::queries {

/// By distance, and of the same by body.
struct Nearer {
  bool operator()(const Neighbor& one, const Neighbor& other) const {
    return one.distance != other.distance ? one.distance < other.distance : one.body < other.body;
  }
};

/// By time, and of the same by body.
struct Sooner {
  bool operator()(const Touch& one, const Touch& other) const {
    return one.time != other.time ? one.time < other.time : one.body < other.body;
  }
};

/// Ascending; no two of them are the same.
void sort_ids(const QueryKernels& kernels, std::span<BodyId> ids);

/// Nearer ones first.
void sort_neighbors(std::span<Neighbor> neighbors);

/// Sooner ones first; some may be the same.
void sort_touches(std::span<Touch> touches);

}  // namespace cellsweep::queries
