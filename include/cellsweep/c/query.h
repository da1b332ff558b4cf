/// @file
/// From C: questions to a world between two updates. Which bodies are here, on this way, or nearest?
///
/// cellsweep/query.h says what is answered, how it is computed and in which order; in short: the world as of
/// its last update; bodies ascend, touches ascend by (time, body), neighbours by (distance, body); what a
/// callback gets comes in no order. Any number of threads may ask at a time. Questions of one call are
/// answered by the engine's threads where there are many.
///
/// Errors of each, by which nothing is answered: INVALID_BOX (NaN, infinity or min > max in a box or a point)
/// and BAD_INPUT (a direction that is zero, NaN or out of the range of a float; an end or distance that is
/// negative or NaN).
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "cellsweep/c/boxes.h"
#include "cellsweep/c/broadphase.h"
#include "cellsweep/c/find_pairs.h"
#include "cellsweep/c/status.h"
#include "cellsweep/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/// All points that are no further than `distance`, 0 or more, from a box.
typedef struct cellsweep_region {
  cellsweep_aabb box;
  double distance;
} cellsweep_region;

/// Where a box, or the point that one is, comes along: by `direction` in each unit of time, from 0 to `end`.
typedef struct cellsweep_path {
  cellsweep_aabb box;
  double direction[3];  ///< of any length but none; a component may be zero
  double end;           ///< 0 or more, infinity allowed
} cellsweep_path;

/// A body on a path.
typedef struct cellsweep_touch {
  uint32_t body;
  double time;  ///< of the first touch; 0 where the path begins in the body's box
} cellsweep_touch;

/// A body and how far it is: 0 where the boxes share a point.
typedef struct cellsweep_neighbor {
  uint32_t body;
  double distance;
} cellsweep_neighbor;

/// The first body on a path, if there is one.
typedef struct cellsweep_first_touch {
  bool is_there;
  cellsweep_touch touch;  ///< zeros where there is none
} cellsweep_first_touch;

/// Which bodies are answers at all. NULL in the place of one: all.
typedef struct cellsweep_query_filter {
  /// Only those that a body with this filter may form a pair with; NULL: all.
  const cellsweep_filter* as;
  /// Only those for which it returns true; NULL: all. Several threads may call it at a time.
  bool (*predicate)(void* context, uint32_t id);
  void* context;
} cellsweep_query_filter;

/// The box that holds one point and no other.
static inline cellsweep_aabb cellsweep_box_at(float x, float y, float z) {
  const cellsweep_aabb box = {{x, y, z}, {x, y, z}};
  return box;
}

/// What is in a box.
static inline cellsweep_region cellsweep_box_region(cellsweep_aabb box) {
  const cellsweep_region region = {box, 0};
  return region;
}

/// What a sphere touches.
static inline cellsweep_region cellsweep_sphere(float x, float y, float z, double radius) {
  const cellsweep_region region = {cellsweep_box_at(x, y, z), radius};
  return region;
}

/// A ray without an end.
static inline cellsweep_path cellsweep_ray(const float origin[3], const double direction[3]) {
  const cellsweep_path path = {cellsweep_box_at(origin[0], origin[1], origin[2]),
                               {direction[0], direction[1], direction[2]},
                               (double)INFINITY};
  return path;
}

/// All points from one to another: times go from 0 to 1.
static inline cellsweep_path cellsweep_segment(const float from[3], const float to[3]) {
  const cellsweep_path path = {cellsweep_box_at(from[0], from[1], from[2]),
                               {(double)to[0] - from[0], (double)to[1] - from[1], (double)to[2] - from[2]},
                               1};
  return path;
}

/// A box that moves by `direction`: times go from 0 to 1.
static inline cellsweep_path cellsweep_moving_box(cellsweep_aabb box, const double direction[3]) {
  const cellsweep_path path = {box, {direction[0], direction[1], direction[2]}, 1};
  return path;
}

/// Makes the tree now that questions about paths and what is near are answered with, or brings it up to date:
/// worth it before many of them. Otherwise that is done once they have taken as long. Errors: NO_MEMORY.
CELLSWEEP_API cellsweep_status cellsweep_prepare_queries(const cellsweep_broadphase* broadphase,
                                                         cellsweep_failure* failure);

// --- lists of answers

/// The answers to the questions of one call, whose memory is used again.
typedef struct cellsweep_answers cellsweep_answers;

/// An empty one. Errors: NO_MEMORY.
CELLSWEEP_API cellsweep_status cellsweep_answers_create(cellsweep_answers** made, cellsweep_failure* failure);
CELLSWEEP_API void cellsweep_answers_destroy(cellsweep_answers* answers);

/// Bodies that overlap each of some regions: cellsweep_bodies() tells them.
CELLSWEEP_API cellsweep_status cellsweep_find_overlaps(const cellsweep_broadphase* broadphase,
                                                       const cellsweep_region* regions, size_t count,
                                                       const cellsweep_query_filter* filter,
                                                       cellsweep_answers* answers,
                                                       cellsweep_failure* failure);
/// Bodies that each of some paths touches: cellsweep_touches() tells them.
CELLSWEEP_API cellsweep_status cellsweep_find_touches(const cellsweep_broadphase* broadphase,
                                                      const cellsweep_path* paths, size_t count,
                                                      const cellsweep_query_filter* filter,
                                                      cellsweep_answers* answers, cellsweep_failure* failure);
/// The `nearest` bodies that are nearest to each of some boxes, none further than `most`, which may be
/// infinity: cellsweep_neighbors() tells them.
CELLSWEEP_API cellsweep_status cellsweep_find_nearest(const cellsweep_broadphase* broadphase,
                                                      const cellsweep_aabb* boxes, size_t count,
                                                      size_t nearest, double most,
                                                      const cellsweep_query_filter* filter,
                                                      cellsweep_answers* answers, cellsweep_failure* failure);
/// Bodies within the distance of each of some regions from its box: cellsweep_neighbors() tells them.
CELLSWEEP_API cellsweep_status cellsweep_find_within(const cellsweep_broadphase* broadphase,
                                                     const cellsweep_region* regions, size_t count,
                                                     const cellsweep_query_filter* filter,
                                                     cellsweep_answers* answers, cellsweep_failure* failure);

/// The answers to one question of the last call that succeeded with them, valid until the next call that is
/// given them to write to. Those to the next question follow them in memory. NULL and a count of 0 for a
/// place that is no question's, and where that call answered another kind of question.
CELLSWEEP_API const uint32_t* cellsweep_bodies(const cellsweep_answers* answers, size_t question,
                                               size_t* count);
CELLSWEEP_API const cellsweep_touch* cellsweep_touches(const cellsweep_answers* answers, size_t question,
                                                       size_t* count);
CELLSWEEP_API const cellsweep_neighbor* cellsweep_neighbors(const cellsweep_answers* answers, size_t question,
                                                            size_t* count);

// --- one answer each

/// Whether a body overlaps each of some regions, into `any`, which has room for one a region.
CELLSWEEP_API cellsweep_status cellsweep_any_overlaps(const cellsweep_broadphase* broadphase,
                                                      const cellsweep_region* regions, size_t count,
                                                      const cellsweep_query_filter* filter, bool* any,
                                                      cellsweep_failure* failure);
/// The first body on each of some paths, into `first`, which has room for one a path.
CELLSWEEP_API cellsweep_status cellsweep_first_touches(const cellsweep_broadphase* broadphase,
                                                       const cellsweep_path* paths, size_t count,
                                                       const cellsweep_query_filter* filter,
                                                       cellsweep_first_touch* first,
                                                       cellsweep_failure* failure);
/// Whether a body is on each of some paths, into `any`, which has room for one a path.
CELLSWEEP_API cellsweep_status cellsweep_any_touches(const cellsweep_broadphase* broadphase,
                                                     const cellsweep_path* paths, size_t count,
                                                     const cellsweep_query_filter* filter, bool* any,
                                                     cellsweep_failure* failure);

// --- one at a time

/// Calls `visit` with each body that overlaps the region until it returns false.
CELLSWEEP_API cellsweep_status cellsweep_visit_overlaps(const cellsweep_broadphase* broadphase,
                                                        const cellsweep_region* region,
                                                        const cellsweep_query_filter* filter,
                                                        bool (*visit)(void* context, uint32_t id),
                                                        void* context, cellsweep_failure* failure);
/// Calls `visit` with bodies that the path touches, nearer ones mostly before others, and with the time at
/// which the path ends now. It returns where the path ends from now on: that time to go on, less to shorten
/// the path, less than 0 to stop.
CELLSWEEP_API cellsweep_status cellsweep_visit_touches(
    const cellsweep_broadphase* broadphase, const cellsweep_path* path, const cellsweep_query_filter* filter,
    double (*visit)(void* context, cellsweep_touch touch, double end), void* context,
    cellsweep_failure* failure);

// --- pairs of some bodies

/// The pairs as of the last update in which one of these bodies is, or both, each once, ascending; the list
/// is overwritten. Errors: UNKNOWN_BODY for one that the last update did not see.
CELLSWEEP_API cellsweep_status cellsweep_find_pairs_of(const cellsweep_broadphase* broadphase,
                                                       cellsweep_ids ids, cellsweep_pair_list* list,
                                                       cellsweep_failure* failure);

#ifdef __cplusplus
}
#endif
