/// @file
/// From C: the version of the library, and the engines that a program has.
#pragma once

#include <stddef.h>

#include "cellsweep/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The version of the library that is linked, as "1.0.0". A literal.
CELLSWEEP_API const char* cellsweep_version(void);

/// How many engines cellsweep_create_engine() knows: those of the library, and those that a program added in
/// C++.
CELLSWEEP_API size_t cellsweep_engine_count(void);
/// The name of the engine at a place below the count; NULL elsewhere. A literal.
CELLSWEEP_API const char* cellsweep_engine_at(size_t place);
/// One sentence about it; NULL elsewhere. A literal.
CELLSWEEP_API const char* cellsweep_engine_summary(size_t place);

#ifdef __cplusplus
}
#endif
