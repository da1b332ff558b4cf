/// @file
/// How a call from C says that it did not do what was asked.
#pragma once

#include <stdint.h>

#include "cellsweep/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The outcome of a call. Numbers stay what they are.
typedef enum cellsweep_status {
  CELLSWEEP_OK = 0,
  CELLSWEEP_INVALID_BOX = 1,      ///< NaN, infinity or min > max
  CELLSWEEP_UNKNOWN_BODY = 2,     ///< an id that is not there
  CELLSWEEP_DUPLICATE_BODY = 3,   ///< an id that is there already, or twice in one call that allows it once
  CELLSWEEP_CAPACITY = 4,         ///< more than a stated limit allows
  CELLSWEEP_BAD_OPTION = 5,       ///< an unknown engine, or a setting out of its range
  CELLSWEEP_BAD_INPUT = 6,        ///< arguments that contradict themselves, or NULL where something is needed
  CELLSWEEP_SPE_FAILED = 7,       ///< an SPE of a Cell engine broke a rule or could not be started
  CELLSWEEP_WRITE_FAILED = 8,     ///< a file could not be written
  CELLSWEEP_NO_MEMORY = 9,        ///< the system, or the caller's allocator or executor, gave none
  CELLSWEEP_CALLBACK_FAILED = 10  ///< a C++ exception left a callback of the caller's
} cellsweep_status;

/// Why a call failed.
typedef struct cellsweep_failure {
  cellsweep_status status;
  uint32_t body_count;  ///< how many of `bodies` there are
  uint32_t bodies[16];  ///< the bodies at fault, in the order of the call, the first 16 of them
  uint64_t number;      ///< what was asked for; of bodies at fault, how many there are in all
  uint64_t limit;       ///< what is allowed, where there is a limit
  char setting[64];     ///< the option to change; empty when none would help
  char message[1024];   ///< a whole sentence for a person; one that is longer is cut
} cellsweep_failure;

/// The name of a status, as "invalid_box"; "unknown" for a number that is none. A literal.
CELLSWEEP_API const char* cellsweep_status_name(int status);

#ifdef __cplusplus
}
#endif
