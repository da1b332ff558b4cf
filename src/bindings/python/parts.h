/// @file
/// What each source of this folder adds to the module.
#pragma once

#include <pybind11/pybind11.h>

#include "bindings/python/locked_world.h"

namespace cellsweep::python {

using WorldClass = pybind11::class_<LockedWorld>;

void add_find_pairs(pybind11::module_& module);
WorldClass add_world(pybind11::module_& module);
void add_history(pybind11::module_& module);
void add_questions(pybind11::module_& module, WorldClass& world);
void add_frames(pybind11::module_& module);

}  // namespace cellsweep::python
