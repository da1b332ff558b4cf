/// @file
/// Where the library's threads come from: its own, or a job system of the caller's.
#pragma once

#include "cellsweep/export.h"

namespace cellsweep {

/// Runs tasks at the same time. The library brings one; a program that has a job system hands in an object
/// of its own class instead (StreamOptions::executor), which must outlive every Broadphase made with it.
/// One Broadphase calls it from one thread at a time; an executor that several of them share must bear calls
/// from as many threads.
class CELLSWEEP_API Executor {
 public:
  using Task = void (*)(void* context, unsigned index);

  virtual ~Executor();

  /// How many tasks may run at the same time, the calling thread's included; 1 or more, and always the same.
  virtual unsigned concurrency() const = 0;

  /// Calls `task(context, i)` once for every i below `count`, in any order and on any threads, and returns
  /// when all have returned. `count` is at most concurrency(). Tasks do not wait for each other, so that one
  /// thread may run them one after the other. They never throw. May throw std::bad_alloc before the first
  /// task has begun.
  virtual void run(unsigned count, Task task, void* context) = 0;
};

}  // namespace cellsweep
