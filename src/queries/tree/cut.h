/// @file
/// Cuts some boxes in two.
#pragma once

#include <cstddef>
#include <span>

#include "queries/tree/range.h"

namespace cellsweep::queries {

/// Neighbours in the list of entries, a box around them, and where their middles are.
struct Part {
  std::span<TreeEntry> entries;
  Range range;
  Range middles;
};

Part part_of(std::span<TreeEntry> entries);

/// Both put the entries of a part, two and more, onto two sides, none of which is empty, and return how many
/// are on the first one. By surface: so that questions come to few of the nodes that the sides will need (the
/// surface area heuristic, in bins: Wald 2007, "On fast construction of SAH-based bounding volume
/// hierarchies"). By number: as many on the one as on the other, but for one.
std::size_t cut_by_surface(const Part& part);
std::size_t cut_by_number(const Part& part);

}  // namespace cellsweep::queries
