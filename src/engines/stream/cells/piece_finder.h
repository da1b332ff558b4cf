/// @file
/// Where the pairs of cells are found when not by this processor's own vectors.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cellsweep/broadphase.h"
#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {

/// Thrown when a PieceFinder cannot go on.
struct PieceFailure {
  Status status;
};

/// One thread uses it.
class PieceFinder {
 public:
  virtual ~PieceFinder() = default;

  /// Appends every pair that one of the cells owns, as Kernels::all_pairs does for each. Throws PieceFailure.
  virtual void find(std::span<const CellBoxes> cells, const BodyId* ids, KeyBuffer& found) = 0;

  /// Appends what it counts over its whole life.
  virtual void add_counters(std::vector<Counter>& counters) const = 0;

  /// On a Cell's clock, since the call before; nothing when that is not counted.
  virtual std::optional<CellTime> take_cell_time() = 0;
};

}  // namespace cellsweep::stream
