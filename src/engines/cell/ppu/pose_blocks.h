/// @file
/// Poses as SPUs want them: four bodies a block, a lane each (F3).
#pragma once

#include <span>

#include "cellsweep/pose.h"
#include "engines/cell/resident_wire.h"

namespace cellsweep::cell {

/// Writes the poses, in their order, into blocks; the lanes left over in the last one get a pose of no
/// consequence.
void pack(std::span<const BodyPose> poses, std::span<PoseBlock> blocks);

}  // namespace cellsweep::cell
