/// @file
/// Walks through the bodies along a path.
#pragma once

#include <span>

#include "cellsweep/function_ref.h"
#include "queries/arithmetic.h"
#include "queries/world.h"

namespace cellsweep::queries {

/// Returns where the path ends from now on, not later than before; less than 0: nowhere.
using Take = FunctionRef<double(std::span<const Candidate>)>;

/// Calls `take` with bodies, those along the first part of the path before others mostly. Every body that the
/// path touches up to its end is among them, several times perhaps, and others are.
void walk_path(const World& world, const Path& path, Take take);

/// The same in no order, for one who wants all up to the path's end and never makes it shorter.
void walk_whole_path(const World& world, const Path& path, Take take);

/// The same for one who takes any body as an answer and wants no more than one: true, and nobody need look,
/// when the path touches one for certain.
bool walk_to_any(const World& world, const Path& path, Take take);

}  // namespace cellsweep::queries
