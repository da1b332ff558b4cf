#include "bindings/python/errors.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <vector>

namespace cellsweep::python {
namespace {

namespace py = pybind11;

/// Where each of the bodies at fault stands in the call: of one that is listed twice, the second place.
std::vector<std::size_t> rows_of(const Status& status, std::span<const BodyId> ids) {
  std::vector<std::size_t> rows;
  for (const BodyId body : status.bodies) {
    auto place = std::find(ids.begin(), ids.end(), body);
    if (status.code == StatusCode::duplicate_body && place != ids.end()) {
      const auto second = std::find(place + 1, ids.end(), body);
      if (second != ids.end()) place = second;
    }
    if (place != ids.end()) rows.push_back(static_cast<std::size_t>(place - ids.begin()));
  }
  if (ids.empty()) rows.assign(status.bodies.begin(), status.bodies.end());
  return rows;
}

}  // namespace

void raise(const Status& status, std::span<const BodyId> ids) {
  const py::object make = py::module_::import("cellsweep.errors").attr("from_status");
  const py::object error = make(static_cast<int>(status.code), status.message, status.bodies,
                                rows_of(status, ids), status.number, status.limit, status.setting);
  PyErr_SetObject(py::type::handle_of(error).ptr(), error.ptr());
  throw py::error_already_set();
}

}  // namespace cellsweep::python
