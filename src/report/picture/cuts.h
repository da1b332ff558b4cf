/// @file
/// How a world is cut into regions for the ranks of a job, for its pictures.
#pragma once

#include <string>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/status.h"
#include "report/picture/picture.h"

namespace cellsweep::report {

/// The regions in what `cellsweep-ranks --json` prints, by rank; sides at the edge of the world are infinite,
/// and a rank without a region has one of no size. Errors: bad_input for anything else.
Result<std::vector<Aabb>> read_cuts(const std::string& json);

/// Draws the regions as frames, as far as they are in the tableau's world, and each body in the colour of the
/// region that holds its lower corner. `boxes` has one for each of the tableau's bodies.
void show_cuts(const std::vector<Aabb>& regions, const std::vector<Aabb>& boxes, Tableau& tableau);

}  // namespace cellsweep::report
