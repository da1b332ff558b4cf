/// @file
/// One frame of a trace.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cellsweep/world/trace.h"

namespace cellsweep {

/// What changed in a frame; the lists are somebody else's.
struct TracePart {
  std::span<const BodyId> inserted;
  std::span<const Aabb> inserted_boxes;
  std::span<const BodyFilter> inserted_filters;  ///< as many, or none
  std::span<const BodyId> removed;
  std::span<const BodyId> moved;
  std::span<const Aabb> moved_boxes;
};

/// The same with lists of its own, which keep their memory from frame to frame.
struct TraceFrame {
  std::vector<BodyId> inserted;
  std::vector<Aabb> inserted_boxes;
  std::vector<BodyFilter> inserted_filters;
  std::vector<BodyId> removed;
  std::vector<BodyId> moved;
  std::vector<Aabb> moved_boxes;

  TracePart part() const { return {inserted, inserted_boxes, inserted_filters, removed, moved, moved_boxes}; }
};

/// Frame number `frame` of a trace that holds together.
TracePart part_of(const Trace& trace, std::size_t frame);

/// What a source tells of the frame that it stands at; at its first all bodies are new.
void take_frame(const FrameSource& source, bool is_first, TraceFrame& frame);

void append(Trace& trace, const TracePart& part);

}  // namespace cellsweep
