/// @file
/// Boxes of the caller's, wherever they lie: arrays of boxes or of coordinates, of floats or doubles, in
/// three dimensions or two.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <ranges>
#include <tuple>
#include <type_traits>

#include "cellsweep/aabb.h"

namespace cellsweep {

/// A closed box: `min[k] <= x <= max[k]` on each axis. `Number` is float or double, `kAxes` 2 or 3. Aabb is
/// the same as `Box<float, 3>`.
template <class Number, std::size_t kAxes>
struct Box {
  std::array<Number, kAxes> min{};
  std::array<Number, kAxes> max{};

  friend bool operator==(const Box&, const Box&) = default;
};

/// One coordinate of each box of a set: that of the first, and how many bytes lie from one to the next, which
/// may be negative. Coordinates need not be aligned.
template <class Number>
struct Coordinates {
  const Number* first = nullptr;
  std::ptrdiff_t stride = sizeof(Number);
};

/// Boxes whose coordinates lie apart, an array for each face, or anywhere else at equal distances.
template <class Number, std::size_t kAxes>
struct CoordinateArrays {
  std::array<Coordinates<Number>, kAxes> min{};
  std::array<Coordinates<Number>, kAxes> max{};
  std::size_t count = 0;  ///< of boxes
};

/// Whether an array of them can be viewed.
template <class Type>
struct IsBox : std::false_type {};
template <>
struct IsBox<Aabb> : std::true_type {};
template <class Number, std::size_t kAxes>
struct IsBox<Box<Number, kAxes>>
    : std::bool_constant<(std::same_as<Number, float> || std::same_as<Number, double>)&&(kAxes == 2 ||
                                                                                         kAxes == 3)> {};

/// A vector, an array, a span of boxes.
template <class Range>
concept BoxRange = std::ranges::contiguous_range<Range> && std::ranges::sized_range<Range> &&
    IsBox<std::remove_cv_t<std::ranges::range_value_t<Range>>>::value;

/// Boxes to read, which stay the caller's and where they are while a call that was given them lasts.
/// Copies view the same boxes.
class BoxView {
 public:
  /// Where a coordinate of the boxes lies: of the first one, and bytes from one to the next.
  struct Face {
    const std::byte* first = nullptr;
    std::ptrdiff_t stride = 0;
  };

  template <BoxRange Boxes>
  BoxView(const Boxes& boxes)  // NOLINT(*-explicit-*): as a span is made of a vector
      : BoxView(std::ranges::data(boxes), static_cast<std::size_t>(std::ranges::size(boxes))) {}

  template <class Number, std::size_t kAxes>
  requires IsBox<Box<Number, kAxes>>::value BoxView(
      const CoordinateArrays<Number, kAxes>& arrays)  // NOLINT(*-explicit-*)
      : count_(arrays.count), axes_(kAxes), is_double_(std::same_as<Number, double>) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      faces_[axis] = face_of(arrays.min[axis].first, arrays.min[axis].stride);
      faces_[axis + 3] = face_of(arrays.max[axis].first, arrays.max[axis].stride);
    }
  }

  std::size_t size() const { return count_; }
  /// 2 or 3.
  std::size_t axes() const { return axes_; }
  /// Of doubles, else of floats.
  bool is_double() const { return is_double_; }
  /// The minima on the axes are faces 0 to 2, the maxima 3 to 5. In two dimensions 2 and 5 are null.
  const Face& face(std::size_t index) const { return faces_[index]; }

 private:
  template <class Number>
  static Face face_of(const Number* first, std::ptrdiff_t stride) {
    return {reinterpret_cast<const std::byte*>(first), stride};
  }

  template <class AnyBox>
  BoxView(const AnyBox* boxes, std::size_t count) : count_(count) {
    using Axes = decltype(boxes->min);
    axes_ = std::tuple_size_v<Axes>;
    is_double_ = std::same_as<typename Axes::value_type, double>;
    if (boxes == nullptr) return;
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      faces_[axis] = face_of(boxes->min.data() + axis, sizeof(AnyBox));
      faces_[axis + 3] = face_of(boxes->max.data() + axis, sizeof(AnyBox));
    }
  }

  std::array<Face, 6> faces_{};
  std::size_t count_ = 0;
  std::size_t axes_ = 3;
  bool is_double_ = false;
};

}  // namespace cellsweep
