/// @file
/// A trace to test with.
#pragma once

#include "cellsweep/world/trace.h"

namespace cellsweep {

inline Aabb cube(float at) {
  return {{at, at, at}, {at + 1, at + 1, at + 1}};
}

/// Three frames: 0, 1 and 2 are there; 0 goes, 1 moves, 5 comes; another 0 comes, 2 goes, 5 moves.
inline Trace three_bodies_and_two_more() {
  Trace trace;
  trace.name = "five";
  trace.inserted = {0, 1, 2, 5, 0};
  trace.inserted_boxes = {cube(0), cube(3), cube(6), cube(8), cube(20)};
  trace.inserted_filters = {{1, 7, true}, {2, 7, false}, {4, 7, false}, {1, 7, false}, {1, 3, false}};
  trace.inserted_ends = {3, 4, 5};
  trace.removed = {0, 2};
  trace.removed_ends = {0, 1, 2};
  trace.moved = {1, 5};
  trace.moved_boxes = {cube(4), cube(9)};
  trace.moved_ends = {0, 1, 2};
  return trace;
}

}  // namespace cellsweep
