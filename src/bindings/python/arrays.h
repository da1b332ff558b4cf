/// @file
/// NumPy's arrays as the library takes them, and its lists as NumPy's arrays; neither copied without need.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/box_view.h"
#include "cellsweep/filter.h"
#include "cellsweep/pair.h"

namespace cellsweep::python {

namespace py = pybind11;

/// Boxes from Python, and what they lie in.
struct Boxes {
  py::array min;
  py::array max;  ///< the same for points
  BoxView view = std::span<const Aabb>();
};

/// Boxes of shape (n, 2, d) or (n, 2 d), a pair of arrays (n, d) or, for points, one (n, d); d is 2 or 3; one
/// box or point may come without its n. Floats and doubles stay where they are, others become doubles. Throws
/// ValueError for other shapes.
Boxes read_boxes(const py::object& from);

/// Ids from an array of whole numbers, or one. Throws TypeError for others, OverflowError with the row for
/// numbers that are not 0 to 2^32 - 1.
class Ids {
 public:
  explicit Ids(const py::object& from);

  std::span<const BodyId> view() const { return {array_.data(), static_cast<std::size_t>(array_.size())}; }

 private:
  py::array_t<BodyId, py::array::c_style> array_;
};

/// A filter for each of `count` bodies from a number for all or one for each; nothing where none was given.
/// Throws ValueError for other lengths, OverflowError for numbers that are not 0 to 2^32 - 1.
std::optional<std::vector<BodyFilter>> read_filters(const py::object& category, const py::object& mask,
                                                    const py::object& is_static, std::size_t count);

/// A filter from single numbers; nothing where none was given.
std::optional<BodyFilter> read_filter(const py::object& category, const py::object& mask,
                                      const py::object& is_static);

/// A vector's elements as an array of another shape and number, which has the vector from now on.
template <class Number, class Element>
py::array_t<Number> hand_over(std::vector<Element> elements, std::vector<py::ssize_t> shape) {
  auto* kept = new std::vector<Element>(std::move(elements));
  const py::capsule owner(kept, [](void* memory) { delete static_cast<std::vector<Element>*>(memory); });
  return py::array_t<Number>(std::move(shape), reinterpret_cast<const Number*>(kept->data()), owner);
}

/// (n, 2) ids, or places.
template <class AnyPair>
py::array_t<std::uint32_t> hand_over_pairs(std::vector<AnyPair> pairs) {
  static_assert(sizeof(AnyPair) == 2 * sizeof(std::uint32_t));
  const auto count = static_cast<py::ssize_t>(pairs.size());
  return hand_over<std::uint32_t>(std::move(pairs), {count, 2});
}

/// (n,) numbers.
template <class Number>
py::array_t<Number> hand_over_list(std::vector<Number> numbers) {
  const auto count = static_cast<py::ssize_t>(numbers.size());
  return hand_over<Number>(std::move(numbers), {count});
}

/// (n, 2, 3) floats: the minimum, then the maximum of each.
py::array_t<float> hand_over_boxes(std::vector<Aabb> boxes);

}  // namespace cellsweep::python
