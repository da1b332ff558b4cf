/// @file
/// How far boxes reach, for those who make the tree: all axes in one vector.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "geometry/box_lanes.h"
#include "queries/tree/box_tree.h"

namespace cellsweep::queries {

inline constexpr std::size_t kAxes = 3;

/// A number for each axis, and one that nobody reads.
using Four = Float4;
using FourPlaces = Int4;

/// The least and the greatest of some points, by axis; or of boxes.
struct Range {
  static constexpr float kNone = std::numeric_limits<float>::infinity();

  Four low = {kNone, kNone, kNone, kNone};
  Four high = {-kNone, -kNone, -kNone, -kNone};

  void add(const Range& other) {
    low = smaller(low, other.low);
    high = larger(high, other.high);
  }
  void add(Four point) { add({point, point}); }

  /// How likely a question comes to a box: half of its surface, and a little for its edges, by which what has
  /// no surface differs.
  double weight() const {
    constexpr double kOfEdges = 0x1p-10;
    const double x = double{high[0]} - low[0];
    const double y = double{high[1]} - low[1];
    const double z = double{high[2]} - low[2];
    return x * y + y * z + z * x + kOfEdges * (x + y + z) * (x + y + z);
  }
  /// The sum of its edges; 0 of nothing.
  double reach() const {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) sum += double{high[axis]} - low[axis];
    return sum > 0 ? sum : 0;
  }
};

/// Of the boxes of a node.
inline Range range_of(const TreeNode& node) {
  Range range;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    Four low = {Range::kNone, Range::kNone, Range::kNone, Range::kNone};
    Four high = -low;
    for (std::size_t place = 0; place < TreeNode::kBoxes; place += 4) {
      Four some;
      std::memcpy(&some, node.faces[axis] + place, sizeof(some));
      low = smaller(some, low);  // where nobody is, what there was stays
      std::memcpy(&some, node.faces[axis + kAxes] + place, sizeof(some));
      high = larger(some, high);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      range.low[axis] = low[i] < range.low[axis] ? low[i] : range.low[axis];
      range.high[axis] = high[i] > range.high[axis] ? high[i] : range.high[axis];
    }
  }
  return range;
}

inline Range range_of(const TreeEntry& entry) {
  static_assert(sizeof(TreeEntry) >= 7 * sizeof(float) && sizeof(Aabb) == 6 * sizeof(float));
  const auto* const bytes = reinterpret_cast<const std::byte*>(&entry);
  Four low;
  FourPlaces high;
  std::memcpy(&low, bytes, sizeof(low));
  std::memcpy(&high, bytes + sizeof(entry.box.min), sizeof(high));
  // A slot taken for a float is a denormal, slow to compute with.
  return {low, reinterpret_cast<Four>(high & FourPlaces{-1, -1, -1, 0})};
}

/// Of one of a node's boxes.
inline Range range_in(const TreeNode& node, unsigned place) {
  const auto face = [&](std::size_t number) { return node.faces[number][place]; };
  return {Four{face(0), face(1), face(2), 0}, Four{face(3), face(4), face(5), 0}};
}

inline void put_range(TreeNode& node, unsigned place, const Range& range) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    node.faces[axis][place] = range.low[axis];
    node.faces[axis + kAxes][place] = range.high[axis];
  }
}

/// Half as far from zero as the middle of a box: differences of these are no larger than floats go.
inline Four middle_of(const Range& range) {
  return range.low * 0.25F + range.high * 0.25F;
}

}  // namespace cellsweep::queries
