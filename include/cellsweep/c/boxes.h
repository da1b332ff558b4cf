/// @file
/// Bodies, boxes and filters of a C caller's, wherever they lie in his memory.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/// A closed box: min[k] <= x <= max[k] on the axes k = 0, 1, 2, in the caller's length unit.
typedef struct cellsweep_aabb {
  float min[3];
  float max[3];
} cellsweep_aabb;

/// Two overlapping bodies by their ids, or boxes by their places.
typedef struct cellsweep_pair {
  uint32_t a;
  uint32_t b;
} cellsweep_pair;

/// What a body is, and what it wants to meet. Two bodies form a pair, when their boxes overlap, only where
/// each one's category has a bit in common with the other's mask, and not both are static. A body that was
/// given none has {1, 0xffffffff, false}.
typedef struct cellsweep_filter {
  uint32_t category;
  uint32_t mask;
  bool is_static;
} cellsweep_filter;

/// What coordinates are.
typedef enum cellsweep_number { CELLSWEEP_FLOAT = 0, CELLSWEEP_DOUBLE = 1 } cellsweep_number;

/// One coordinate of each of some boxes: where that of the first lies, and how many bytes lie from one to the
/// next, which may be negative. Coordinates need not be aligned.
typedef struct cellsweep_coordinates {
  const void* first;
  ptrdiff_t stride;
} cellsweep_coordinates;

/// Boxes to read: arrays of boxes, of larger structs that have one, or of coordinates. In two dimensions the
/// third coordinates are not looked at.
typedef struct cellsweep_boxes {
  size_t count;
  uint32_t axes;    ///< 2 or 3
  uint32_t number;  ///< a cellsweep_number
  cellsweep_coordinates min[3];
  cellsweep_coordinates max[3];
} cellsweep_boxes;

/// Ids to read, `stride` bytes from one to the next.
typedef struct cellsweep_ids {
  const uint32_t* first;
  ptrdiff_t stride;
  size_t count;
} cellsweep_ids;

/// Filters to read; a count of 0 where bodies are to have the default.
typedef struct cellsweep_filters {
  const cellsweep_filter* first;
  ptrdiff_t stride;
  size_t count;
} cellsweep_filters;

/// Boxes whose coordinates lie next to each other, in structs that are `stride` bytes apart: `min` and `max`
/// are those of the first one.
static inline cellsweep_boxes cellsweep_boxes_apart(uint32_t number, uint32_t axes, const void* min,
                                                    const void* max, ptrdiff_t stride, size_t count) {
  const size_t bytes = number == CELLSWEEP_DOUBLE ? sizeof(double) : sizeof(float);
  cellsweep_boxes boxes;
  memset(&boxes, 0, sizeof boxes);
  boxes.count = count;
  boxes.axes = axes;
  boxes.number = number;
  if (!min || !max) return boxes;
  for (uint32_t axis = 0; axis < axes && axis < 3; ++axis) {
    boxes.min[axis].first = (const char*)min + axis * bytes;
    boxes.min[axis].stride = stride;
    boxes.max[axis].first = (const char*)max + axis * bytes;
    boxes.max[axis].stride = stride;
  }
  return boxes;
}

/// An array of boxes.
static inline cellsweep_boxes cellsweep_boxes_of(const cellsweep_aabb* boxes, size_t count) {
  // A box begins with its minimum.
  const void* max = boxes ? (const void*)boxes->max : (const void*)boxes;
  return cellsweep_boxes_apart(CELLSWEEP_FLOAT, 3, boxes, max, (ptrdiff_t)sizeof *boxes, count);
}

/// An array of ids.
static inline cellsweep_ids cellsweep_ids_of(const uint32_t* ids, size_t count) {
  const cellsweep_ids view = {ids, (ptrdiff_t)sizeof *ids, count};
  return view;
}

/// An array of filters.
static inline cellsweep_filters cellsweep_filters_of(const cellsweep_filter* filters, size_t count) {
  const cellsweep_filters view = {filters, (ptrdiff_t)sizeof *filters, count};
  return view;
}

/// No filters: the default for all.
static inline cellsweep_filters cellsweep_no_filters(void) {
  cellsweep_filters view;
  memset(&view, 0, sizeof view);
  return view;
}

#ifdef __cplusplus
}
#endif
