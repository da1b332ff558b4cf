/// @file
/// From C: what began and ended since an update that is some updates ago. cellsweep/pair_history.h says how
/// much is remembered.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "cellsweep/c/broadphase.h"
#include "cellsweep/c/status.h"
#include "cellsweep/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Remembers the changes of a world's updates for those who look at it less often.
typedef struct cellsweep_history cellsweep_history;

/// One that remembers at most so many changes, pairs that began and pairs that ended. Errors: NO_MEMORY.
CELLSWEEP_API cellsweep_status cellsweep_history_create(size_t most_pairs, cellsweep_history** made,
                                                        cellsweep_failure* failure);
CELLSWEEP_API void cellsweep_history_destroy(cellsweep_history* history);

/// After each update, what it returned and its number (cellsweep_statistics::updates), which ascends by one.
/// Errors: BAD_INPUT for another number.
CELLSWEEP_API cellsweep_status cellsweep_history_record(cellsweep_history* history, uint64_t update_number,
                                                        const cellsweep_changes* changes,
                                                        cellsweep_failure* failure);

/// What changed since an update, valid until the next call with this history. Errors: CAPACITY for an update
/// that is forgotten, BAD_INPUT for one that is not recorded yet.
CELLSWEEP_API cellsweep_status cellsweep_history_since(cellsweep_history* history, uint64_t update_number,
                                                       cellsweep_changes* changes,
                                                       cellsweep_failure* failure);

#ifdef __cplusplus
}
#endif
