/// @file
/// The module `cellsweep._cellsweep`; what it holds is shown by the package around it.
#include <pybind11/pybind11.h>

#include "bindings/python/parts.h"

PYBIND11_MODULE(_cellsweep, module) {
  using namespace cellsweep::python;
  module.attr("__version__") = CELLSWEEP_VERSION;
  add_find_pairs(module);
  auto world = add_world(module);
  add_questions(module, world);
  add_history(module);
  add_frames(module);
}
