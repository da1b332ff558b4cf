/// @file
/// The document's sort of one axis (X3, X4, X5): insertion sort that tests each pair it swaps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cellsweep/aabb.h"
#include "engines/control/pair_manager.h"

namespace cellsweep::control {

/// Listing 4.3: one end of a body's interval on one axis. The pointers follow the box as it moves.
struct Endpoint {
  int ownerID;
  const Aabb* pBox;
  const float* pValue;

  bool is_max(int axis) const { return pValue == &pBox->max[static_cast<std::size_t>(axis)]; }
};

using EndpointList = std::vector<Endpoint>;

/// What the sort does beside sorting.
struct SortEvents {
  std::vector<PairInfo>*
      changed;  ///< pairs that began or stopped colliding on all three axes, as they are now
  std::uint64_t swaps = 0;
};

/// Sorts an axis by (value, minimum before maximum) and brings `pairs` up to date on that axis
/// (Listings 4.4, 4.5, with the overlap test mended to see an interval that contains the other).
void sort_and_test(EndpointList& list, int axis, PairManager& pairs, SortEvents& events);

/// The listings to the letter: sorts by value only, and misses a containing interval.
void sort_and_test_literal(EndpointList& list, int axis, PairManager& pairs, SortEvents& events);

}  // namespace cellsweep::control
