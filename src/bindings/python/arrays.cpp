#include "bindings/python/arrays.h"

#include <array>
#include <limits>
#include <string>

#include "base/text.h"

namespace cellsweep::python {
namespace {

std::string shape_text(const py::array& array) {
  std::string words = "(";
  for (py::ssize_t k = 0; k < array.ndim(); ++k) words += text(k == 0 ? "" : ", ", array.shape(k));
  return words + (array.ndim() == 1 ? ",)" : ")");
}

[[noreturn]] void refuse_shape(const std::string& shape) {
  throw py::value_error(
      "Boxes have the shape (n, 2, 3), (n, 2, 2), (n, 6) or (n, 4), or are a pair (min, max) of arrays "
      "(n, 3) or (n, 2), and points are one such array; these have the shape " +
      shape + ".");
}

/// As floats or doubles of this machine: the same array where it is.
py::array as_numbers(const py::object& from) {
  if (py::isinstance<py::array_t<float>>(from) || py::isinstance<py::array_t<double>>(from)) {
    return py::reinterpret_borrow<py::array>(from);
  }
  auto array = py::array_t<double>::ensure(from);
  if (!array) {
    PyErr_Clear();
    throw py::type_error("Boxes are arrays of numbers.");
  }
  return array;
}

bool is_dimension(py::ssize_t axes) {
  return axes == 2 || axes == 3;
}

/// Where the numbers of some boxes lie in their arrays.
struct Layout {
  py::ssize_t count = 0;
  py::ssize_t axes = 0;
  py::ssize_t min_stride = 0;  // bytes from a box to the next
  py::ssize_t max_stride = 0;
  py::ssize_t min_axis_stride = 0;  // and from an axis to the next
  py::ssize_t max_axis_stride = 0;
  const std::byte* min = nullptr;
  const std::byte* max = nullptr;
};

const std::byte* data_of(const py::array& array) {
  return static_cast<const std::byte*>(array.data());
}

/// One array: (n, 2, d), (n, 2 d) or points (n, d).
Layout layout_of(const py::array& array) {
  const py::ssize_t last = array.ndim() - 1;
  if (last < 0 || last > 2) refuse_shape(shape_text(array));
  Layout layout;
  const bool is_one = last == 0;
  layout.count = is_one ? 1 : array.shape(0);
  layout.min_stride = layout.max_stride = is_one ? 0 : array.strides(0);
  layout.min_axis_stride = layout.max_axis_stride = array.strides(last);
  layout.min = layout.max = data_of(array);
  const py::ssize_t numbers = array.shape(last);
  if (last == 2) {
    if (array.shape(1) != 2 || !is_dimension(numbers)) refuse_shape(shape_text(array));
    layout.axes = numbers;
    layout.max += array.strides(1);
  } else if (is_dimension(numbers)) {
    layout.axes = numbers;
  } else if (numbers == 4 || numbers == 6) {
    layout.axes = numbers / 2;
    layout.max += layout.axes * array.strides(last);
  } else {
    refuse_shape(shape_text(array));
  }
  return layout;
}

Layout layout_of(const py::array& min, const py::array& max) {
  const Layout low = layout_of(min);
  const Layout high = layout_of(max);
  const bool are_points = low.min == low.max && high.min == high.max && min.ndim() < 3 && max.ndim() < 3;
  if (!are_points || low.count != high.count || low.axes != high.axes) {
    refuse_shape(shape_text(min) + " and " + shape_text(max));
  }
  Layout layout = low;
  layout.max = high.max;
  layout.max_stride = high.max_stride;
  layout.max_axis_stride = high.max_axis_stride;
  return layout;
}

template <class Number, std::size_t kAxes>
BoxView view_as(const Layout& layout) {
  CoordinateArrays<Number, kAxes> arrays;
  arrays.count = static_cast<std::size_t>(layout.count);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const auto k = static_cast<py::ssize_t>(axis);
    arrays.min[axis] = {reinterpret_cast<const Number*>(layout.min + k * layout.min_axis_stride),
                        layout.min_stride};
    arrays.max[axis] = {reinterpret_cast<const Number*>(layout.max + k * layout.max_axis_stride),
                        layout.max_stride};
  }
  return arrays;
}

template <class Number>
BoxView view_of(const Layout& layout) {
  return layout.axes == 2 ? view_as<Number, 2>(layout) : view_as<Number, 3>(layout);
}

bool is_of_floats(const py::array& array) {
  return py::isinstance<py::array_t<float>>(array);
}

/// Numbers 0 to 2^32 - 1: one for each of `count`, or one for all. The error names what they are.
class Words {
 public:
  Words(const py::object& from, std::size_t count, const char* name) {
    array_ = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(from);
    if (!array_) {
      PyErr_Clear();
      throw py::type_error(text("`", name, "` is a whole number, or an array of them."));
    }
    if (array_.ndim() != 0 && (array_.ndim() != 1 || static_cast<std::size_t>(array_.size()) != count)) {
      throw py::value_error(text("`", name, "` has the shape ", shape_text(array_),
                                 "; it is one number, or one for each of ", count, " bodies."));
    }
    for (py::ssize_t i = 0; i < array_.size(); ++i) {
      const std::int64_t number = array_.data()[i];
      if (number >= 0 && number <= std::numeric_limits<std::uint32_t>::max()) continue;
      PyErr_SetString(PyExc_OverflowError,
                      text("`", name, "` is ", number, " in row ", i, "; it is 0 to 4294967295.").c_str());
      throw py::error_already_set();
    }
  }

  std::uint32_t operator[](std::size_t i) const {
    return static_cast<std::uint32_t>(array_.data()[array_.ndim() == 0 ? 0 : i]);
  }

 private:
  py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> array_;
};

}  // namespace

Boxes read_boxes(const py::object& from) {
  Boxes boxes;
  Layout layout;
  if (py::isinstance<py::tuple>(from) && py::len(from) == 2) {
    const auto pair = py::reinterpret_borrow<py::tuple>(from);
    boxes.min = as_numbers(pair[0]);
    boxes.max = as_numbers(pair[1]);
    if (is_of_floats(boxes.min) != is_of_floats(boxes.max)) {
      boxes.min = py::array_t<double>::ensure(boxes.min);
      boxes.max = py::array_t<double>::ensure(boxes.max);
    }
    layout = layout_of(boxes.min, boxes.max);
  } else {
    boxes.min = boxes.max = as_numbers(from);
    layout = layout_of(boxes.min);
  }
  boxes.view = is_of_floats(boxes.min) ? view_of<float>(layout) : view_of<double>(layout);
  return boxes;
}

Ids::Ids(const py::object& from) {
  const auto any = py::array::ensure(from);
  const char kind = any ? any.dtype().kind() : '?';
  const bool is_empty = any && any.size() == 0;
  if (kind != 'u' && kind != 'i' && !is_empty) {
    PyErr_Clear();
    throw py::type_error("Ids are whole numbers.");
  }
  if (any.ndim() > 1) throw py::value_error("Ids have the shape (n,); these have " + shape_text(any) + ".");
  if (!py::isinstance<py::array_t<BodyId>>(any) && !is_empty) {
    // A view of what is larger than 64 signed bits would wrap around.
    const bool is_wide = any.dtype().kind() == 'u' && any.itemsize() == 8;
    if (is_wide) {
      const auto wide = py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>::ensure(any);
      for (py::ssize_t i = 0; i < wide.size(); ++i) {
        if (wide.data()[i] <= std::numeric_limits<std::uint32_t>::max()) continue;
        PyErr_SetString(
            PyExc_OverflowError,
            text("The id in row ", i, " is ", wide.data()[i], "; ids are 0 to 4294967295.").c_str());
        throw py::error_already_set();
      }
    } else {
      const Words checked(any, static_cast<std::size_t>(any.size()), "ids");
    }
  }
  array_ = py::array_t<BodyId, py::array::c_style | py::array::forcecast>::ensure(any);
}

std::optional<std::vector<BodyFilter>> read_filters(const py::object& category, const py::object& mask,
                                                    const py::object& is_static, std::size_t count) {
  if (category.is_none() && mask.is_none() && is_static.is_none()) return {};
  std::vector<BodyFilter> filters(count);
  if (!category.is_none()) {
    const Words words(category, count, "category");
    for (std::size_t i = 0; i < count; ++i) filters[i].category = words[i];
  }
  if (!mask.is_none()) {
    const Words words(mask, count, "mask");
    for (std::size_t i = 0; i < count; ++i) filters[i].mask = words[i];
  }
  if (!is_static.is_none()) {
    const Words words(is_static, count, "static");
    for (std::size_t i = 0; i < count; ++i) filters[i].is_static = words[i] != 0;
  }
  return filters;
}

std::optional<BodyFilter> read_filter(const py::object& category, const py::object& mask,
                                      const py::object& is_static) {
  const auto filters = read_filters(category, mask, is_static, 1);
  if (!filters) return {};
  return filters->front();
}

py::array_t<float> hand_over_boxes(std::vector<Aabb> boxes) {
  const auto count = static_cast<py::ssize_t>(boxes.size());
  return hand_over<float>(std::move(boxes), {count, 2, 3});
}

}  // namespace cellsweep::python
