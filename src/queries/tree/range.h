/// @file
/// How far boxes reach, for those who make the tree: all axes in one vector.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "queries/tree/box_tree.h"

namespace cellsweep::queries {

inline constexpr std::size_t kAxes = 3;

/// A number for each axis, and one that nobody reads.
using Four [[gnu::vector_size(16)]] = float;
using FourPlaces [[gnu::vector_size(16)]] = std::int32_t;

inline Four smaller(Four a, Four b) {
  return a < b ? a : b;
}
inline Four larger(Four a, Four b) {
  return a > b ? a : b;
}

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
};

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

/// Half as far from zero as the middle of a box: differences of these are no larger than floats go.
inline Four middle_of(const Range& range) {
  return range.low * 0.25F + range.high * 0.25F;
}

}  // namespace cellsweep::queries
