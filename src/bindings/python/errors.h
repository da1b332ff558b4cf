/// @file
/// A status as Python's exception.
#pragma once

#include <pybind11/pybind11.h>

#include <span>

#include "cellsweep/pair.h"
#include "cellsweep/status.h"

namespace cellsweep::python {

/// Throws the exception of cellsweep.errors that belongs to a status, which is not ok. `ids` are those of the
/// call, in which the rows of the bodies at fault are found; without any the bodies are called by their rows.
/// With the interpreter's lock.
[[noreturn]] void raise(const Status& status, std::span<const BodyId> ids = {});

/// The same where there is anything to throw.
inline void raise_unless_ok(const Status& status, std::span<const BodyId> ids = {}) {
  if (!status.ok()) raise(status, ids);
}

}  // namespace cellsweep::python
