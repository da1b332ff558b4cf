/// @file
/// The frames of a recording that several share.
#pragma once

#include <memory>

#include "cellsweep/world/recording.h"

namespace cellsweep {

std::unique_ptr<FrameSource> make_recording_frames(std::shared_ptr<const Recording> recording);

}  // namespace cellsweep
