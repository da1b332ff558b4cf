/// @file
/// A look into engine `stream`: what it keeps around bodies and where it searches, for pictures and
/// debugging.
#pragma once

#include <optional>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/broadphase.h"
#include "cellsweep/export.h"

namespace cellsweep {

/// As of the last update().
struct StreamView {
  /// One a body, in any order: the box around it that it may move in before its pairs are searched anew. In a
  /// small world in motion, where that is done in every update, the body's own box.
  std::vector<Aabb> fat_boxes;
  /// The cells that bodies are in, within each other where one was crowded, in any order. None while a small
  /// world has been swept instead.
  std::vector<Aabb> cells;
};

/// Nothing for an engine that is not `stream`. Takes time and memory with the bodies and the cells.
CELLSWEEP_API std::optional<StreamView> stream_view(const Broadphase& broadphase);

}  // namespace cellsweep
