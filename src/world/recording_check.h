/// @file
/// What a recording must be before it goes into a file.
#pragma once

#include "cellsweep/status.h"
#include "cellsweep/world/recording.h"

namespace cellsweep {

/// Errors: bad_input for no frames, boxes that do not fill whole frames, or a box that no reader would take.
Status check_recording(const Recording& recording);

}  // namespace cellsweep
