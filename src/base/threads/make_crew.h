/// @file
/// Where the workers of an engine and of a one-shot call come from.
#pragma once

#include <memory>

#include "base/threads/crew.h"
#include "cellsweep/executor.h"

namespace cellsweep {

/// Workers of `executor`, or, where that is null, threads of the library's own: so many, or as many as pay
/// for 0 (Crew::Choice::by_gain).
///
/// When nobody has a crew with threads of the library's own any more, the process keeps it for whoever next
/// wants as many workers: an engine that is made anew for each frame does not start threads each time, nor
/// measure what they cost. Two are kept at most, until the process ends or the library is unloaded. Safe to
/// call from any thread, and in a child of fork(), where their threads start anew.
std::shared_ptr<Crew> make_crew(std::shared_ptr<Executor> executor, unsigned threads);

}  // namespace cellsweep
