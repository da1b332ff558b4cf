/// @file
/// The boxes of one call: checked, and read from wherever the caller has them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "base/memory/array.h"
#include "cellsweep/aabb.h"
#include "cellsweep/box_view.h"
#include "cellsweep/status.h"

namespace cellsweep::one_shot {

/// One set, or two to find pairs between; they have the same kind of boxes.
using Sets = std::span<const BoxView>;

/// As they are compared exactly, by place: those of the first set, then those of the second.
using ExactBox = Box<double, 3>;

/// Boxes to search among. Those of two sets lie one after the other, and of these some may be left out.
struct SearchedBoxes {
  std::span<const Aabb> boxes;     ///< by slot, canonical
  std::uint32_t second = 0;        ///< the slot of the second set's first box; of one set how many there are
  std::uint32_t second_place = 0;  ///< and its place
  Array<Aabb> own{};               ///< where they lie, if not with the caller
  Array<std::uint32_t> places{};   ///< by slot, ascending; empty where they are the slots
  bool are_two = false;
};

/// Refuses sets of different kinds, without addresses, or with more boxes than fit.
Status check_sets(Sets sets);

/// Boxes of floats, canonical: the caller's own where they are so already. Errors: invalid_box.
Status read_floats(Sets sets, SearchedBoxes& boxes);

/// Boxes of doubles. Errors: invalid_box.
Status read_doubles(Sets sets, Array<ExactBox>& boxes);

}  // namespace cellsweep::one_shot
