/// @file
/// The world of bodies from C: bodies in, overlapping pairs and their changes out.
///
/// cellsweep/broadphase.h says what holds for each call in C++; the same holds here. In short: insertions,
/// moves, new filters and removals are checked at once, each call whole, and take effect together in the next
/// cellsweep_update(). Until then, and after an update that failed, pairs and boxes are those of the update
/// before.
///
/// The boxes of a world are floats in three dimensions. Others are made so on the way in: doubles are rounded
/// outward to the next float, by which boxes may touch that do not quite; two dimensions have 0 to 0 as the
/// third.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "cellsweep/c/boxes.h"
#include "cellsweep/c/executor.h"
#include "cellsweep/c/status.h"
#include "cellsweep/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A set of bodies with boxes, and their overlapping pairs as of the last update.
typedef struct cellsweep_broadphase cellsweep_broadphase;

/// The instruction set of vector kernels.
typedef enum cellsweep_isa {
  CELLSWEEP_ISA_BEST = 0,  ///< the widest that the processor has
  CELLSWEEP_ISA_PORTABLE = 1,
  CELLSWEEP_ISA_SSE41 = 2,
  CELLSWEEP_ISA_AVX2 = 3,
  CELLSWEEP_ISA_AVX512 = 4
} cellsweep_isa;

/// Settings of engine `stream`: {.size = sizeof options} and zeros are the defaults.
typedef struct cellsweep_stream_options {
  size_t size;       ///< of this struct, by which a library and a program of different versions agree
  unsigned threads;  ///< the caller's included; 0: as many as the machine has, 16 at most, where they pay
  uint32_t isa;      ///< a cellsweep_isa
  const cellsweep_executor* executor;  ///< copied; NULL: threads of the library's own
  uint64_t max_pairs;  ///< an update that finds more fails with CELLSWEEP_CAPACITY; 0 for no limit
  const char* trace;   ///< a file for a timeline, copied; NULL for none
  float margin;        ///< how far a body may move about at little cost; 0: what is found to pay
} cellsweep_stream_options;

/// A setting of an engine by its name in the table of engines, as text.
typedef struct cellsweep_setting {
  const char* name;
  const char* value;
} cellsweep_setting;

/// An empty world with engine `stream`; `options` NULL for the defaults. Errors: BAD_OPTION.
CELLSWEEP_API cellsweep_status cellsweep_create(const cellsweep_stream_options* options,
                                                cellsweep_broadphase** made, cellsweep_failure* failure);
/// An empty world with an engine of the table (cellsweep/c/engines.h). Errors: BAD_OPTION.
CELLSWEEP_API cellsweep_status cellsweep_create_engine(const char* engine, const cellsweep_setting* settings,
                                                       size_t setting_count, cellsweep_broadphase** made,
                                                       cellsweep_failure* failure);
CELLSWEEP_API void cellsweep_destroy(cellsweep_broadphase* broadphase);

/// The name of its engine; valid as long as the world is.
CELLSWEEP_API const char* cellsweep_engine_name(const cellsweep_broadphase* broadphase);
/// The number of bodies that there may be.
CELLSWEEP_API uint64_t cellsweep_capacity(const cellsweep_broadphase* broadphase);

// --- what changes the world

/// Adds bodies; an id may occur once in a call. Errors: BAD_INPUT (counts that differ), INVALID_BOX,
/// DUPLICATE_BODY, CAPACITY.
CELLSWEEP_API cellsweep_status cellsweep_insert(cellsweep_broadphase* broadphase, cellsweep_ids ids,
                                                cellsweep_boxes boxes, cellsweep_filters filters,
                                                cellsweep_failure* failure);
/// Adds bodies whose ids the library hands out, into `ids`, which has room for one a box: none that is in
/// use, none whose pairs have not been reported as ended, and all below the most bodies that there were at a
/// time, or below twice that where the caller chose ids or changed filters, too. Errors: those of
/// cellsweep_insert().
CELLSWEEP_API cellsweep_status cellsweep_add(cellsweep_broadphase* broadphase, cellsweep_boxes boxes,
                                             uint32_t* ids, cellsweep_failure* failure);
/// Gives bodies new boxes. Of several for one body before an update the last counts. Errors: BAD_INPUT,
/// INVALID_BOX, UNKNOWN_BODY.
CELLSWEEP_API cellsweep_status cellsweep_move(cellsweep_broadphase* broadphase, cellsweep_ids ids,
                                              cellsweep_boxes boxes, cellsweep_failure* failure);
/// Gives bodies other filters: pairs that these do not allow end at the next update, and those that they
/// allow begin. Errors: BAD_INPUT, UNKNOWN_BODY.
CELLSWEEP_API cellsweep_status cellsweep_set_filters(cellsweep_broadphase* broadphase, cellsweep_ids ids,
                                                     cellsweep_filters filters, cellsweep_failure* failure);
/// Removes bodies; an id may occur once in a call. Their pairs end at the next update. Errors: UNKNOWN_BODY,
/// DUPLICATE_BODY.
CELLSWEEP_API cellsweep_status cellsweep_remove(cellsweep_broadphase* broadphase, cellsweep_ids ids,
                                                cellsweep_failure* failure);

/// What changed between two updates, each list ascending by (a, b).
typedef struct cellsweep_changes {
  const cellsweep_pair* began;  ///< overlap now, did not at the update before
  size_t began_count;
  const cellsweep_pair* ended;  ///< overlapped at the update before, do not now
  size_t ended_count;
} cellsweep_changes;

/// Brings the pairs up to date with all calls since the last update and says what changed, unless `changes`
/// is NULL; the lists stay valid until the next update. Errors: those that the engine's settings name.
CELLSWEEP_API cellsweep_status cellsweep_update(cellsweep_broadphase* broadphase, cellsweep_changes* changes,
                                                cellsweep_failure* failure);

// --- what the world holds

/// The pairs as of the last update, ascending by (a, b), a < b; valid until the next one. Errors: NO_MEMORY.
CELLSWEEP_API cellsweep_status cellsweep_pairs(const cellsweep_broadphase* broadphase,
                                               const cellsweep_pair** pairs, size_t* count,
                                               cellsweep_failure* failure);
/// Copies the boxes as of the last update into `boxes`, which has room for one an id. Errors: UNKNOWN_BODY
/// for one that the last update did not see.
CELLSWEEP_API cellsweep_status cellsweep_read_boxes(const cellsweep_broadphase* broadphase, cellsweep_ids ids,
                                                    cellsweep_aabb* boxes, cellsweep_failure* failure);
/// Bodies held now, whether or not an update has seen them.
CELLSWEEP_API size_t cellsweep_size(const cellsweep_broadphase* broadphase);
/// Whether a body is held now.
CELLSWEEP_API bool cellsweep_contains(const cellsweep_broadphase* broadphase, uint32_t id);
/// The filter that counts from the next update on. Errors: UNKNOWN_BODY for one that is not held now.
CELLSWEEP_API cellsweep_status cellsweep_filter_of(const cellsweep_broadphase* broadphase, uint32_t id,
                                                   cellsweep_filter* filter, cellsweep_failure* failure);

// --- what it counted

/// Over the world's whole life; numbers that an engine does not count are 0.
typedef struct cellsweep_statistics {
  uint64_t updates;         ///< that succeeded
  uint64_t bytes;           ///< of memory held, nearly
  uint64_t boxes_placed;    ///< put into cells, or what the engine has in their place
  uint64_t boxes_compared;  ///< pairs of boxes that were held against each other
  size_t phase_count;       ///< of the last update
  size_t counter_count;
} cellsweep_statistics;

/// The time that one step of the last update took.
typedef struct cellsweep_phase {
  const char* name;  ///< a literal
  double milliseconds;
} cellsweep_phase;

/// A number that an engine counts, for people to read.
typedef struct cellsweep_counter {
  const char* name;  ///< a literal
  uint64_t value;
} cellsweep_counter;

CELLSWEEP_API cellsweep_statistics cellsweep_statistics_of(const cellsweep_broadphase* broadphase);
/// The phase at a place below `phase_count`; NULL as its name elsewhere.
CELLSWEEP_API cellsweep_phase cellsweep_phase_at(const cellsweep_broadphase* broadphase, size_t place);
/// The counter at a place below `counter_count`; NULL as its name elsewhere.
CELLSWEEP_API cellsweep_counter cellsweep_counter_at(const cellsweep_broadphase* broadphase, size_t place);

#ifdef __cplusplus
}
#endif
