/// @file
/// What the shared library shows: everything else in it is hidden. For C++ and C.
#pragma once

#if !defined(__GNUC__)
#define CELLSWEEP_API
#elif defined(__cplusplus)
#define CELLSWEEP_API [[gnu::visibility("default")]]
#else
#define CELLSWEEP_API __attribute__((visibility("default")))
#endif
