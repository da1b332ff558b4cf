/// @file
/// The caller's own memory for what grows with bodies and pairs.
#pragma once

#include <stddef.h>

#include "cellsweep/c/status.h"
#include "cellsweep/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Where the library takes its memory from. Called from any thread, several at a time.
typedef struct cellsweep_allocator {
  /// Memory for `bytes`, 1 or more, at a multiple of `alignment`, a power of two; NULL where there is none.
  void* (*take)(void* context, size_t bytes, size_t alignment);
  /// Gives back what take() returned; not called with NULL.
  void (*give)(void* context, void* memory);
  void* context;
} cellsweep_allocator;

/// Takes memory from the caller, for the whole process and in C++, too: what grows with bodies, boxes and
/// pairs. Objects of a few hundred bytes, copies of a call's boxes and lists of answers come from C++'s
/// operator new, which a program can replace. To be called before anything else of the library, and while no
/// other thread calls it. Errors: BAD_INPUT once the library has taken any memory from elsewhere.
CELLSWEEP_API cellsweep_status cellsweep_set_allocator(const cellsweep_allocator* allocator,
                                                       cellsweep_failure* failure);

#ifdef __cplusplus
}
#endif
