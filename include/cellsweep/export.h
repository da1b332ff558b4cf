/// @file
/// What the shared library shows: everything else in it is hidden.
#pragma once

#if defined(__GNUC__)
#define CELLSWEEP_API [[gnu::visibility("default")]]
#else
#define CELLSWEEP_API
#endif
