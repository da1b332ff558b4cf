/// @file
/// The truth that engines are judged by: all boxes against all boxes.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/filter.h"
#include "cellsweep/pair.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep::report {

/// The oracle's name in engine_table().
inline constexpr std::string_view kOracle = "oracle";

/// With more bodies a frame of the oracle takes seconds: where nobody asked for it, it is left out.
inline constexpr std::size_t kMostBodiesOfOracle = 20'000;

/// Every overlapping pair of bodies 0 … n − 1, ascending. Boxes are valid.
std::vector<Pair> oracle_pairs(std::span<const Aabb> boxes);

/// The same of some bodies; the boxes are by id, and so are filters, where there are any.
std::vector<Pair> oracle_pairs(std::span<const BodyId> bodies, std::span<const Aabb> boxes,
                               std::span<const BodyFilter> filters = {});

/// Of those that are in the frame a source stands at.
std::vector<Pair> oracle_pairs(const FrameSource& source);

}  // namespace cellsweep::report
