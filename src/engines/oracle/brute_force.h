/// @file
/// The oracle: all boxes against all boxes. Nothing cleverer judges the engines.
#pragma once

#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// Every overlapping pair of the given bodies, in ascending order. The boxes are made canonical first, as
/// engines do. Ids must differ and boxes be valid; `ids` and `boxes` have one length n. O(n²) time, O(n +
/// pairs) memory.
std::vector<Pair> brute_force_pairs(std::span<const BodyId> ids, std::span<const Aabb> boxes);

/// The same for bodies 0 … n − 1.
std::vector<Pair> brute_force_pairs(std::span<const Aabb> boxes);

}  // namespace cellsweep
