/// @file
/// What happens to poses before SPUs make boxes of them.
#pragma once

#include <span>
#include <vector>

#include "cellsweep/pair.h"
#include "cellsweep/pose.h"
#include "cellsweep/status.h"

namespace cellsweep::cell {

/// The poses with canonical values, as of boxes. Errors: invalid_box with all bodies whose pose breaks the
/// rules of BodyPose. `ids` and `poses` have one length.
Result<std::vector<BodyPose>> checked_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses);

}  // namespace cellsweep::cell
