/// @file
/// Frames of boxes, wherever they come from: a simulated world, a recording, or the caller's own data.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/export.h"
#include "cellsweep/filter.h"
#include "cellsweep/pair.h"
#include "cellsweep/pose.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// A sequence of frames, and the bodies in them. It stands at frame 0 when it is made. As it comes, the
/// bodies are the same in all frames, 0 … n − 1; a source whose bodies come and go says so, and overrides
/// what names them. One thread at a time.
class CELLSWEEP_API FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// What a person would call it, for tables: a scene's name or a file's.
  virtual std::string name() const = 0;

  /// Whether there are frames with other bodies than frame 0 has; the same in all frames.
  virtual bool bodies_come_and_go() const { return false; }

  /// The boxes of the frame it stands at, indexed by body id, as many in all frames. Those of ids that no
  /// body has are of no meaning. Valid until advance().
  virtual std::span<const Aabb> boxes() const = 0;

  /// The bodies that are there, ascending; by default 0 … boxes().size() − 1. Valid until advance().
  virtual std::span<const BodyId> bodies() const;

  /// The poses of the bodies, indexed as the boxes; empty when the source knows none. They are those of the
  /// last frame in which the body's box changed. Valid until advance().
  virtual std::span<const BodyPose> poses() const { return {}; }

  /// The filters of the bodies, indexed as the boxes; a body keeps the one that it came with. Empty when all
  /// have the default. Valid until advance().
  virtual std::span<const BodyFilter> filters() const { return {}; }

  /// The bodies that were there in the frame before and whose box has changed since, ascending; empty at
  /// frame 0. Valid until advance().
  virtual std::span<const BodyId> moved() const = 0;

  /// The bodies that were not there in the frame before, and those that were and are not any more, ascending;
  /// empty at frame 0. An id that goes may come again, for another body, from the frame after on. Valid until
  /// advance().
  virtual std::span<const BodyId> inserted() const { return {}; }
  virtual std::span<const BodyId> removed() const { return {}; }

  /// Goes to the next frame; false, and no change, when there is none, or status() says why it cannot be had.
  virtual bool advance() = 0;

  /// Not ok when frame 0, or the next one, cannot be had, as of a file that cannot be read any more.
  virtual Status status() const { return {}; }

 private:
  mutable std::vector<BodyId> all_;  // what bodies() hands out unless it is overridden
};

}  // namespace cellsweep
