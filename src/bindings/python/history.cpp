#include <pybind11/pybind11.h>

#include <memory>

#include "bindings/python/arrays.h"
#include "bindings/python/errors.h"
#include "bindings/python/parts.h"
#include "cellsweep/pair_history.h"

namespace cellsweep::python {
namespace {

using namespace py::literals;
using PairArray = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>;

/// (m, 2) ids.
std::span<const Pair> pairs_in(const PairArray& array) {
  if (array.ndim() != 2 || array.shape(1) != 2) throw py::value_error("Pairs have the shape (m, 2).");
  return {reinterpret_cast<const Pair*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

void record(PairHistory& history, std::uint64_t number, const py::object& changes) {
  const PairArray began(py::object(changes.attr("began")));
  const PairArray ended(py::object(changes.attr("ended")));
  raise_unless_ok(history.record(number, {pairs_in(began), pairs_in(ended)}));
}

py::object since(PairHistory& history, std::uint64_t number) {
  const auto found = history.since(number);
  raise_unless_ok(found.status());
  return py::module_::import("cellsweep")
      .attr("Changes")(hand_over_pairs(std::vector(found->began.begin(), found->began.end())),
                       hand_over_pairs(std::vector(found->ended.begin(), found->ended.end())));
}

}  // namespace

void add_history(py::module_& module) {
  py::class_<PairHistory>(
      module, "PairHistory",
      R"(Remembers the changes of updates for those who look less often: PairHistory(most_pairs).

One thread at a time.)")
      .def(py::init<std::size_t>(), "most_pairs"_a)
      .def("record", record, "update_number"_a, "changes"_a,
           R"(After each update: its number, World.statistics["updates"], and what it returned.)")
      .def("since", since, "update_number"_a,
           R"(Changes(began, ended) since an update, as if that and the last one had followed each other.

Raises CapacityError for an update that is forgotten, InputError for one not recorded yet.)");
}

}  // namespace cellsweep::python
