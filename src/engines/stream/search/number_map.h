/// @file
/// Coordinates as small numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {

/// Maps that never decrease, so that boxes that overlap do so in small numbers, too: up to 65,536 of them on
/// the axis by which boxes are put in order, 256 on the others.
class NumberMap {
 public:
  static constexpr std::uint32_t kMostPlaces = 1U << 16;

  /// Looks at a few boxes.
  [[gnu::cold]] void learn(std::span<const Aabb> boxes);
  /// Whether what was learnt is still good for these, as far as a few of them tell: where boxes were some
  /// updates ago they mostly still are. Counts how often it was used.
  bool is_good_for(const Kernels& kernels, std::span<const Aabb> boxes);

  /// With how many behind it a box would be compared in the order of the axis, in the mean, as far as a few
  /// of them tell.
  [[gnu::cold]] double comparisons(const Kernels& kernels, std::span<const Aabb> boxes) const;

  const GridNumbers& numbers() const { return numbers_; }
  unsigned axis() const { return axis_; }           ///< of the order
  std::uint32_t places() const { return places_; }  ///< numbers on it, a power of two

 private:
  template <std::size_t kCount, class See>
  void look_at(const Kernels& kernels, std::span<const Aabb> boxes, const See& see) const;
  [[gnu::cold]] bool most_are_inside(const Kernels& kernels, std::span<const Aabb> boxes) const;

  GridNumbers numbers_{};
  unsigned axis_ = 0;
  std::uint32_t places_ = 0;
  std::uint32_t uses_ = 0;       // 0: nothing learnt
  std::size_t slots_known_ = 0;  // there were so many
};

}  // namespace cellsweep::stream
