/// @file
/// What has to be known of boxes before a grid is chosen for them.
#pragma once

#include <array>

#include "engines/stream/cells/grid.h"

namespace cellsweep::stream {

/// Where most of the minima lie on an axis.
struct AxisRange {
  double origin = 0;
  double length = 0;
  double low = 0;  ///< the ends of all that were looked at
  double high = 0;
};

/// Means over boxes, of their edges and of the edges' products, which say how many cells a box reaches into.
/// Of an edge counts what lies in the range of its axis: there are no more cells than that.
struct Extents {
  double x = 0, y = 0, z = 0, xy = 0, yz = 0, zx = 0, xyz = 0;

  void add(const std::array<double, 3>& edges);
  void add(const Extents& other, double weight);

  /// The expected number of cells of a box, for so many borders between cells a unit of length on each axis.
  double copies(const std::array<double, 3>& density) const;
};

/// Ranges come from a few of the boxes, and so do the means, or both from all.
struct BoxSample {
  std::array<AxisRange, 3> axes;
  Extents extents;
};

BoxSample take_sample(const Boxes& boxes, Look look);

/// Of a few boxes and no others: how much very long ones add to the means is left to chance. For who would
/// lose more by looking at all boxes.
BoxSample take_rough_sample(const Boxes& boxes);

}  // namespace cellsweep::stream
