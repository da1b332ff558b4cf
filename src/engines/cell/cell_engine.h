/// @file
/// What the functions of cell.h ask engines for that run on SPEs.
#pragma once

#include <span>

#include "cellsweep/aabb.h"
#include "cellsweep/cell.h"

namespace cellsweep::cell {

/// What works on SPEs, as of its last update.
class CellEngine {
 public:
  virtual ~CellEngine() = default;

  virtual const CellStatistics& cell_statistics() const = 0;
};

/// What makes boxes from poses (F3).
class PoseBoxes {
 public:
  virtual ~PoseBoxes() = default;

  /// False for an engine that was made without room for them.
  virtual bool takes_poses() const = 0;

  /// A box for each pose, which must be valid and canonical, at once. Errors: spe_failed; the engine has
  /// failed then, and its next update() says so, too.
  virtual Status make_boxes(std::span<const BodyPose> poses, std::span<Aabb> boxes) = 0;
};

}  // namespace cellsweep::cell
