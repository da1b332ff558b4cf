/// @file
/// Engine `stream` with the pairs of its cells found elsewhere than by this processor's own vectors.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/engine/cell_boxes.h"
#include "cellsweep/export.h"
#include "cellsweep/statistics.h"
#include "cellsweep/status.h"

namespace cellsweep::stream {

// Of the cells that two overlapping boxes share, one owns the pair: that which holds the lower corner of
// what they share. It does when on each axis one of the two minima lies in the cell, which the tags tell:
// together they have all of kWholeFlags.

/// Thrown when a PieceFinder cannot go on.
struct CELLSWEEP_API PieceFailure {
  Status status;
};

/// One thread uses it.
class CELLSWEEP_API PieceFinder {
 public:
  virtual ~PieceFinder() = default;

  /// What it does from now on belongs to one update, whether or not that needs it.
  virtual void begin_update() = 0;

  /// Appends every pair that one of the cells owns, each once. Throws PieceFailure.
  virtual void find(std::span<const CellBoxes> cells, KeyBuffer& found) = 0;

  /// Appends what it counts over its whole life.
  virtual void add_counters(std::vector<Counter>& counters) const = 0;
};

/// What an engine with a PieceFinder offers to those who made it.
class CELLSWEEP_API HasFinder {
 public:
  /// Null when the kernels find pairs.
  virtual const PieceFinder* finder() const = 0;

 protected:
  ~HasFinder() = default;
};

/// Makes what finds pairs in the kernels' place, again after it has failed.
using FinderMaker = std::function<Result<std::unique_ptr<PieceFinder>>()>;

/// A broadphase whose engine is called `name`, a literal, with the kernels of `options` or a finder. Errors:
/// those of make_broadphase(StreamOptions) and of the finder's maker.
CELLSWEEP_API Result<Broadphase> make_stream_broadphase(const StreamOptions& options, std::string_view name,
                                                        FinderMaker make_finder, std::string row_name);

}  // namespace cellsweep::stream
