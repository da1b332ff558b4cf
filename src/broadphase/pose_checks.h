/// @file
/// What an engine that takes poses does to them before anything is applied.
#pragma once

#include "cellsweep/pair.h"
#include "cellsweep/pose.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// A pose of canonical values, as of boxes.
BodyPose canonical(const BodyPose& pose);

/// True for a pose that keeps the rules of BodyPose.
bool is_valid(const BodyPose& pose);

/// The status that names what is wrong with a pose that is not valid.
Status invalid_box_status(BodyId body, const BodyPose& pose);

}  // namespace cellsweep
