/// @file
/// Writing NumPy's .npy; reading it is parse_npy() of the public face.
#pragma once

#include <cstddef>
#include <vector>

#include "cellsweep/status.h"
#include "cellsweep/world/recording.h"
#include "world/files/recording_head.h"

namespace cellsweep {

/// What is before the boxes; name, type and world have no place in it.
Result<std::vector<std::byte>> npy_head(const RecordingHead& head);

/// The whole file: format version 1.0, little-endian float32, shape (frames, bodies, 6). Name, type and world
/// have no place in it. Errors: those of check_recording().
Result<std::vector<std::byte>> npy_bytes(const Recording& recording);

}  // namespace cellsweep
