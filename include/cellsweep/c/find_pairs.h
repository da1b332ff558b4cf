/// @file
/// From C: overlapping pairs of boxes at once, of one set or between two, with no world to keep.
/// cellsweep/find_pairs.h says what holds for each call.
///
/// Boxes are called by their places in the call, 0, 1, .... Those of doubles are compared as doubles, in two
/// dimensions or three. Both sets of a call are of the same kind.
///
/// Errors of each: BAD_OPTION, BAD_INPUT (NULL for coordinates; sets of different kinds), INVALID_BOX,
/// CAPACITY.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "cellsweep/c/boxes.h"
#include "cellsweep/c/broadphase.h"
#include "cellsweep/c/executor.h"
#include "cellsweep/c/status.h"
#include "cellsweep/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Settings of a search: {.size = sizeof options} and zeros are the defaults.
typedef struct cellsweep_find_options {
  size_t size;                         ///< of this struct
  unsigned threads;                    ///< as those of cellsweep_stream_options
  uint32_t isa;                        ///< a cellsweep_isa
  const cellsweep_executor* executor;  ///< NULL: threads of the call's own
  uint64_t max_pairs;                  ///< a call that finds more fails with CELLSWEEP_CAPACITY; 0: no limit
} cellsweep_find_options;

/// A list of pairs that calls write and whose memory is used again.
typedef struct cellsweep_pair_list cellsweep_pair_list;

/// An empty list. Errors: NO_MEMORY.
CELLSWEEP_API cellsweep_status cellsweep_pair_list_create(cellsweep_pair_list** made,
                                                          cellsweep_failure* failure);
CELLSWEEP_API void cellsweep_pair_list_destroy(cellsweep_pair_list* list);
/// The pairs that the last call which succeeded wrote into the list; valid until the next call that is given
/// the list to write to.
CELLSWEEP_API const cellsweep_pair* cellsweep_listed_pairs(const cellsweep_pair_list* list, size_t* count);

/// All pairs of one set, a < b, ascending; the list is overwritten.
CELLSWEEP_API cellsweep_status cellsweep_find_pairs(cellsweep_boxes boxes,
                                                    const cellsweep_find_options* options,
                                                    cellsweep_pair_list* list, cellsweep_failure* failure);
/// All pairs of a box `a` of the first set and one `b` of the second, ascending.
CELLSWEEP_API cellsweep_status cellsweep_find_pairs_between(cellsweep_boxes first, cellsweep_boxes second,
                                                            const cellsweep_find_options* options,
                                                            cellsweep_pair_list* list,
                                                            cellsweep_failure* failure);

/// How many there are.
CELLSWEEP_API cellsweep_status cellsweep_count_pairs(cellsweep_boxes boxes,
                                                     const cellsweep_find_options* options, uint64_t* count,
                                                     cellsweep_failure* failure);
CELLSWEEP_API cellsweep_status cellsweep_count_pairs_between(cellsweep_boxes first, cellsweep_boxes second,
                                                             const cellsweep_find_options* options,
                                                             uint64_t* count, cellsweep_failure* failure);

/// Gets a pair and says whether to go on.
typedef bool (*cellsweep_pair_visitor)(void* context, cellsweep_pair pair);

/// Calls `visit` with each pair, once, in no stated order, on the calling thread, until it returns false;
/// that is no error.
CELLSWEEP_API cellsweep_status cellsweep_visit_pairs(cellsweep_boxes boxes,
                                                     const cellsweep_find_options* options,
                                                     cellsweep_pair_visitor visit, void* context,
                                                     cellsweep_failure* failure);
CELLSWEEP_API cellsweep_status cellsweep_visit_pairs_between(cellsweep_boxes first, cellsweep_boxes second,
                                                             const cellsweep_find_options* options,
                                                             cellsweep_pair_visitor visit, void* context,
                                                             cellsweep_failure* failure);

#ifdef __cplusplus
}
#endif
