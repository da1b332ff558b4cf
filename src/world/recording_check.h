/// @file
/// What a recording must be before it goes into a file.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "cellsweep/aabb.h"
#include "cellsweep/status.h"
#include "cellsweep/world/recording.h"

namespace cellsweep {

/// Errors: bad_input for a source whose bodies come and go or have filters.
Status check_fits_recording(const FrameSource& source);

/// bad_input for the first box of a frame that no reader would take, if there is one.
std::optional<Status> find_faulty_box(std::span<const Aabb> boxes, std::size_t frame);

/// Errors: bad_input for no frames, boxes that do not fill whole frames, or a box that no reader would take.
Status check_recording(const Recording& recording);

}  // namespace cellsweep
