/// @file
/// Where the pairs of cells are found when not by this processor's own vectors.
#pragma once

#include <span>
#include <vector>

#include "cellsweep/statistics.h"
#include "cellsweep/status.h"
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

  /// What it does from now on belongs to one update, whether or not that needs it.
  virtual void begin_update() = 0;

  /// Appends every pair that one of the cells owns, as Kernels::all_pairs does for each. Throws PieceFailure.
  virtual void find(std::span<const CellBoxes> cells, KeyBuffer& found) = 0;

  /// Appends what it counts over its whole life.
  virtual void add_counters(std::vector<Counter>& counters) const = 0;
};

/// What an engine with a PieceFinder offers to those who made it.
class HasFinder {
 public:
  /// Null when the kernels find pairs.
  virtual const PieceFinder* finder() const = 0;

 protected:
  ~HasFinder() = default;
};

}  // namespace cellsweep::stream
