/// @file
/// A job system of a C caller's, for the library to run its tasks on.
#pragma once

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/// What an executor is to call, with the number of the task.
typedef void (*cellsweep_task)(void* task_context, unsigned index);

/// Runs tasks at the same time. Several objects that share one may call it from several threads.
typedef struct cellsweep_executor {
  /// How many tasks may run at the same time, the calling thread's included; 1 or more.
  unsigned concurrency;
  /// Calls `task(task_context, i)` once for every i below `count`, which is at most `concurrency`, in any
  /// order and on any threads, and returns true when all have returned. Tasks do not wait for each other.
  /// Returns false, before the first task has begun, where there is no memory to run them.
  bool (*run)(void* context, unsigned count, cellsweep_task task, void* task_context);
  void* context;
  /// Called when a world that was made with the executor is destroyed; NULL for nothing. Calls that fail, and
  /// one-shot searches, do not call it.
  void (*release)(void* context);
} cellsweep_executor;

#ifdef __cplusplus
}
#endif
