#include "cellsweep/find_pairs.h"

#include <pybind11/pybind11.h>

#include <string>

#include "bindings/python/arrays.h"
#include "bindings/python/errors.h"
#include "bindings/python/parts.h"

namespace cellsweep::python {
namespace {

FindPairsOptions options_of(unsigned threads, std::uint64_t max_pairs) {
  FindPairsOptions options;
  options.threads = threads;
  options.max_pairs = max_pairs;
  return options;
}

/// What `search()` finds, without the interpreter's lock.
template <class Search>
auto found_by(const Search& search) {
  auto found = [&] {
    const py::gil_scoped_release released;
    return search();
  }();
  raise_unless_ok(found.status());
  return std::move(*found);
}

py::array find(const py::object& boxes, const py::object& others, unsigned threads, std::uint64_t max_pairs) {
  const FindPairsOptions options = options_of(threads, max_pairs);
  const Boxes a = read_boxes(boxes);
  if (others.is_none()) return hand_over_pairs(found_by([&] { return find_pairs(a.view, options); }));
  const Boxes b = read_boxes(others);
  return hand_over_pairs(found_by([&] { return find_pairs(a.view, b.view, options); }));
}

std::uint64_t count(const py::object& boxes, const py::object& others, unsigned threads,
                    std::uint64_t max_pairs) {
  const FindPairsOptions options = options_of(threads, max_pairs);
  const Boxes a = read_boxes(boxes);
  if (others.is_none()) return found_by([&] { return count_pairs(a.view, options); });
  const Boxes b = read_boxes(others);
  return found_by([&] { return count_pairs(a.view, b.view, options); });
}

}  // namespace

void add_find_pairs(py::module_& module) {
  using namespace py::literals;
  module.def("find_pairs", find, "boxes"_a, "others"_a = py::none(), py::kw_only(), "threads"_a = 0,
             "max_pairs"_a = 0,
             R"(All pairs of boxes that overlap, as an array (m, 2) of row numbers, uint32.

Of one set: each pair once, the smaller row first, ascending. Between two sets: a row of
`boxes` and one of `others`, ascending. Boxes are closed: those that only touch overlap.
The result is exact, and the same for any number of threads.

boxes, others: the shape (n, 2, d) or (n, 2 * d), minimum before maximum, or a pair
    (min, max) of arrays (n, d); d is 2 or 3; arrays (n, d) are points. float32 and float64
    are read where they lie, with any strides, and compared as they are (float32: -0 and
    denormal values count as 0); others become float64. Both sets are of the same kind.
threads: the caller's included; 0 for as many as pay.
max_pairs: raise CapacityError where there are more; 0 for no limit.

Raises InvalidBoxError, which names the rows, for NaN, infinity or a minimum above its
maximum; InputError, CapacityError, ValueError for shapes. Other Python threads run
meanwhile; the arrays must not change.)");
  module.def("count_pairs", count, "boxes"_a, "others"_a = py::none(), py::kw_only(), "threads"_a = 0,
             "max_pairs"_a = 0, R"(How many pairs find_pairs() would list; it takes no memory for them.)");
}

}  // namespace cellsweep::python
