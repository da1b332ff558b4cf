/// @file
/// Walks through the bodies that are within a distance of a box.
#pragma once

#include <span>

#include "cellsweep/function_ref.h"
#include "queries/regions/reach.h"
#include "queries/world.h"

namespace cellsweep::queries {

/// Calls `take` with the slots of those that are, each once, until it returns false.
void visit_near(const World& world, const Reach& reach, FunctionRef<bool(std::span<const Slot>)> take);

/// Calls `take` with all of them, as many at a time as can be.
void list_near(const World& world, const Reach& reach, FunctionRef<void(std::span<const Slot>)> take);

/// The same with how far they are: distance_of() of each.
void measure_near(const World& world, const Reach& reach,
                  FunctionRef<void(std::span<const Slot>, const double* distances)> take);

}  // namespace cellsweep::queries
