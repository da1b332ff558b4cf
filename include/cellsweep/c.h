/// @file
/// The library in C11: all of it, but for the Cell engines' own settings and what works on scenes.
///
/// Rules that hold for every function:
///
/// Failure: what can fail returns a cellsweep_status and takes, last, a cellsweep_failure of the caller's, or
/// NULL, that is written when the status is not CELLSWEEP_OK: a sentence, the bodies at fault, the numbers. A
/// call that fails has changed nothing and may be made again. No C++ exception leaves a call. Where an
/// object, an answer's place or a callback is needed and NULL was given, the call fails with
/// CELLSWEEP_BAD_INPUT; functions that return no status then return nothing: 0, false, NULL.
///
/// Ownership: what a function with "create" in its name made is the caller's, who gives it back with the
/// function with "destroy" of the same name, which takes NULL, too. Arrays that the caller hands in are read
/// or written during the call and never kept. Arrays that the library hands out are the object's and stay
/// valid for as long as the comment says.
///
/// Threads: an object belongs to one thread at a time; any number of threads may call functions that take it
/// as a pointer to const while no other function is called with it. Different objects are independent.
///
/// Boxes are closed: those that only touch overlap. Everything is exact: the pairs and answers are those of
/// comparing all boxes with all boxes, in the same order whatever the threads and the machine.
#pragma once

#include "cellsweep/c/broadphase.h"
#include "cellsweep/c/engines.h"
#include "cellsweep/c/find_pairs.h"
#include "cellsweep/c/history.h"
#include "cellsweep/c/memory.h"
#include "cellsweep/c/query.h"
