/// @file
/// What the shared library shows: everything else in it is hidden.
#pragma once

#if defined(__GNUC__)
#define CELLSWEEP_API __attribute__((visibility("default")))
#else
#define CELLSWEEP_API
#endif
