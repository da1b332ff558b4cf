/// @file
/// Frames of boxes, wherever they come from: a simulated world, a recording, or the caller's own data.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "cellsweep/aabb.h"
#include "cellsweep/export.h"
#include "cellsweep/pair.h"
#include "cellsweep/pose.h"

namespace cellsweep {

/// A sequence of frames over a fixed set of bodies with ids 0 … n − 1. It stands at frame 0 when it is made.
/// One thread at a time.
class CELLSWEEP_API FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// What a person would call it, for tables: a scene's name or a file's.
  virtual std::string name() const = 0;

  /// The boxes of the frame it stands at, indexed by body id. Valid until advance().
  virtual std::span<const Aabb> boxes() const = 0;

  /// The poses of the bodies, indexed as the boxes; empty when the source knows none. They are those of the
  /// last frame in which the body's box changed. Valid until advance().
  virtual std::span<const BodyPose> poses() const { return {}; }

  /// The bodies whose box differs from the frame before, ascending; empty at frame 0. Valid until advance().
  virtual std::span<const BodyId> moved() const = 0;

  /// Goes to the next frame; false, and no change, when there is none.
  virtual bool advance() = 0;
};

}  // namespace cellsweep
