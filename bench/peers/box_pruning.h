/// @file
/// The simple way to be fast, as a yardstick: a radix sort along one axis, and a sweep that compares a box
/// with eight followers at a time. One thread, nothing kept from frame to frame.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/pair.h"

namespace cellsweep::bench {

/// Boxes in the order of their lower ends on the axis of the sweep, a list for each coordinate. Behind the
/// last come kPadding boxes that begin after everything.
struct SweepLists {
  static constexpr std::size_t kPadding = 8;

  std::size_t count = 0;                  ///< without the padding
  std::array<std::vector<float>, 3> min;  ///< axis 0 is the one swept along
  std::array<std::vector<float>, 3> max;
  std::vector<BodyId> ids;
};

/// Appends the overlapping pairs to the list.
using Sweep = void (*)(const SweepLists& lists, std::vector<Pair>& pairs);

void sweep_portable(const SweepLists& lists, std::vector<Pair>& pairs);
#ifdef CELLSWEEP_X86_PRUNING
void sweep_avx2(const SweepLists& lists, std::vector<Pair>& pairs);
#endif

/// The fastest sweep that this processor can run.
Sweep best_sweep();

/// Finds pairs by sorting and sweeping. One thread at a time; memory is kept between calls.
class BoxPruning {
 public:
  explicit BoxPruning(Sweep sweep = best_sweep()) : sweep_(sweep) {}

  /// The overlapping pairs of bodies 0 … n − 1 into a list of the caller's, over what is in it, in any order.
  /// Boxes are finite, with min <= max.
  void find_pairs(std::span<const Aabb> boxes, std::vector<Pair>& pairs);

 private:
  void sort(std::span<const Aabb> boxes, std::size_t axis);
  void fill_lists(std::span<const Aabb> boxes, std::size_t axis);

  Sweep sweep_;
  std::vector<std::uint64_t> keys_;  // the lower end on the axis in the high half, the id in the low one
  std::vector<std::uint64_t> other_keys_;
  SweepLists lists_;
};

}  // namespace cellsweep::bench
